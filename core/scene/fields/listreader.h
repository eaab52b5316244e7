// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fields/numberreader.h"
#include "core/scene/fields/partreader.h"
#include "core/scene/fields/primitivefields.h"
#include "core/scene/text/colourreader.h"

namespace pixelplumb {

/// Reads parts of a scene by their lists of fields; a field that is missing keeps its value, unless
/// it is required. Reader, the class that derives from it, has read(node, value) for each other
/// kind of value. Errors stay with the JsonReader.
template <class Reader>
class ListReader {
public:
    template <class Part>
    void readFields(const JsonNode &node, Part &part)
    {
        eachField(part, [&](const char *name, auto &&value) {
            const JsonNode field = node[name];
            if ((isRequired(value) || !field.isMissing()) && !m_json.hasFailed())
                self().read(field, value);
        });
    }

protected:
    ListReader(JsonReader &json, CurrentScene &current)
        : m_json(json)
        , m_current(current)
        , m_numbers(json, current.reading.snaps)
    {
    }

    /// Fails on keys that are neither the part's nor one of `more`.
    template <class Part>
    void readObject(const JsonNode &node, Part &part, const QStringList &more = {})
    {
        m_json.expectObject(node, fieldNames(part) + more);
        readFields(node, part);
    }

    template <class Value>
    void read(const JsonNode &node, const Required<Value> &field)
    {
        self().read(node, field.value);
    }
    template <class Value>
    void read(const JsonNode &node, std::optional<Value> &value)
    {
        self().read(node, value.emplace());
    }
    /// Of an array, whose values may be fields.
    template <class Values>
    requires(std::tuple_size<Values>::value > 0) void read(const JsonNode &node, Values &values)
    {
        const std::vector<JsonNode> nodes = m_json.array(node, qsizetype(values.size()));
        for (std::size_t i = 0; i < nodes.size() && !m_json.hasFailed(); ++i)
            self().read(nodes[i], values[i]);
    }
    template <class Number>
    void read(const JsonNode &node, const NumberWithin<Number> &field)
    {
        field.number = Number(m_json.integer(node, field.first, field.last));
    }
    void read(const JsonNode &node, std::string &text) { text = m_json.string(node).toStdString(); }
    void read(const JsonNode &node, double &number) { number = m_numbers.real(node); }
    void read(const JsonNode &node, Attribute &number) { number = m_numbers.attribute(node); }
    void read(const JsonNode &node, LatticePoint &point) { point = m_numbers.position(node); }
    void read(const JsonNode &node, Colour &colour) { colour = readColour(m_json, node); }

    void read(const JsonNode &node, const AboveZero<double> &field)
    {
        field.number = m_numbers.real(node);
        if (field.number <= 0)
            m_json.fail(node, u"%1 of %2"_s.arg(QLatin1String(field.what), describe(node)),
                        "more than 0");
    }
    void read(const JsonNode &node, const AboveZero<Lattice> &field)
    {
        field.number = m_numbers.coordinate(node);
        if (field.number <= 0)
            m_json.fail(
                node, u"%1 of %2 px"_s.arg(QLatin1String(field.what), coordinateText(field.number)),
                u"1/%1 px or more"_s.arg(unitsPerPixel));
    }
    template <class Vertex, class Value>
    void read(const JsonNode &node, const OfEach<Vertex, Value> &field)
    {
        const std::vector<JsonNode> nodes = m_json.array(node, qsizetype(field.vertices.size()));
        for (std::size_t i = 0; i < nodes.size() && !m_json.hasFailed(); ++i)
            self().read(nodes[i], field.vertices[i].*field.value);
    }
    template <class Vertex, class Blended>
    void read(const JsonNode &node, const BlendedColours<Vertex, Blended> &field)
    {
        const std::vector<JsonNode> nodes = m_json.array(node, qsizetype(field.vertices.size()));
        for (std::size_t i = 0; i < nodes.size() && !m_json.hasFailed(); ++i) {
            const BlendedColour colour = readBlendedColour(m_json, nodes[i]);
            field.vertices[i].colour = colour.colour;
            field.opacities[i].alpha = colour.alpha;
        }
    }
    void read(const JsonNode &node, const ColourOfAll<Vertex> &field)
    {
        const Colour colour = readColour(m_json, node);
        for (Vertex &vertex : field.vertices)
            vertex.colour = colour;
    }
    template <class Blended>
    void read(const JsonNode &node, const ColourOfAll<Blended> &field)
    {
        const BlendedColour colour = readBlendedColour(m_json, node);
        for (Blended &each : field.vertices) {
            each.colour = colour.colour;
            each.alpha = colour.alpha;
        }
    }
    void read(const JsonNode &node, std::shared_ptr<const Texture> &texture)
    {
        readFile(node, texture, &ReferredFiles::texture);
    }
    void read(const JsonNode &node, std::shared_ptr<const Mesh> &mesh)
    {
        readFile(node, mesh, &ReferredFiles::mesh);
    }

    JsonReader &m_json;
    CurrentScene &m_current;
    NumberReader m_numbers;

private:
    template <class Value>
    static constexpr bool isRequired(const Value & /*value*/)
    {
        return false;
    }
    template <class Value>
    static constexpr bool isRequired(const Required<Value> & /*value*/)
    {
        return true;
    }

    template <class File>
    void readFile(const JsonNode &node, File &file,
                  Result<File> (ReferredFiles::*find)(const QString &))
    {
        const QString name = m_json.string(node);
        if (m_json.hasFailed())
            return;
        if (const auto found = (m_current.files.*find)(name))
            file = *found;
        else
            m_json.fail(node, u"%1: %2"_s.arg(found.error().place, found.error().found),
                        found.error().expected);
    }

    Reader &self() { return static_cast<Reader &>(*this); }
};

} // namespace pixelplumb
