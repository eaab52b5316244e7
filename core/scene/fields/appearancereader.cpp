// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/appearancereader.h"

#include "core/scene/fields/appearancefields.h"
#include "core/scene/text/choicereader.h"
#include "core/scene/text/colourreader.h"

namespace pixelplumb {

namespace {

Light readLight(JsonReader &json, NumberReader &numbers, const JsonNode &node)
{
    json.expectObject(node, {"direction", "position", "color"});
    const JsonNode direction = node["direction"];
    const JsonNode position = node["position"];
    const JsonNode colour = node["color"];
    Light light;
    if (direction.isMissing() == position.isMissing())
        json.fail(node,
                  direction.isMissing() ? QStringLiteral("a light without direction and position")
                                        : QStringLiteral("both direction and position"),
                  "one of the two");
    light.kind = direction.isMissing() ? Light::Kind::Positional : Light::Kind::Directional;
    const JsonNode &at = direction.isMissing() ? position : direction;
    light.at = numbers.attributes<3>(at);
    if (light.kind == Light::Kind::Directional && light.at == std::array<Attribute, 3>{})
        json.fail(at, "a direction of length 0",
                  QStringLiteral("a component of ±1/%1 or more").arg(attributeOne));
    if (!colour.isMissing())
        light.colour = readColour(json, colour);
    return light;
}

/// Reads the fields of parts; a missing field keeps its value.
class FieldsReader {
public:
    FieldsReader(JsonReader &json, NumberReader &numbers, ReferredFiles &files)
        : m_json(json)
        , m_numbers(numbers)
        , m_files(files)
    {
    }

    template <class Part>
    void readFields(const JsonNode &node, Part &part)
    {
        eachField(part, [&](const char *name, auto &&value) {
            if (const JsonNode field = node[name]; !field.isMissing() && !m_json.hasFailed())
                read(field, value);
        });
    }

private:
    void read(const JsonNode &node, Colour &colour) { colour = readColour(m_json, node); }
    template <class Choice, class Choices>
    void read(const JsonNode &node, const ChoiceOf<Choice, Choices> &field)
    {
        readChoice(m_json, node, field.all, field.choice);
    }
    void read(const JsonNode &node, const NumberWithin<int> &field)
    {
        field.number = int(m_json.integer(node, field.first, field.last));
    }
    void read(const JsonNode &node, std::shared_ptr<const Texture> &texture)
    {
        const QString name = m_json.string(node);
        if (m_json.hasFailed())
            return;
        if (const auto read = m_files.texture(name))
            texture = *read;
        else
            m_json.fail(node, QStringLiteral("%1: %2").arg(read.error().place, read.error().found),
                        read.error().expected);
    }
    void read(const JsonNode &node, std::vector<Material> &materials)
    {
        if (!node.isObject())
            m_json.fail(node, describe(node), "an object with a material for each name");
        for (const QString &name : node.keys()) {
            m_json.expectObject(node[name], fieldNames<Material>());
            readFields(node[name], materials.emplace_back());
            materials.back().name = name.toStdString();
        }
    }
    void read(const JsonNode &node, std::vector<Light> &lights)
    {
        const std::vector<JsonNode> nodes = m_json.array(node);
        if (nodes.size() > mostLights)
            m_json.fail(node, QStringLiteral("%1 lights").arg(nodes.size()),
                        QStringLiteral("at most %1").arg(mostLights));
        for (const JsonNode &each : nodes) {
            if (m_json.hasFailed())
                break;
            lights.push_back(readLight(m_json, m_numbers, each));
        }
    }

    JsonReader &m_json;
    NumberReader &m_numbers;
    ReferredFiles &m_files;
};

} // namespace

QStringList appearanceKeys() { return fieldNames<Appearance>(); }

Appearance readAppearance(JsonReader &json, NumberReader &numbers, ReferredFiles &files,
                          const JsonNode &root)
{
    Appearance appearance;
    FieldsReader(json, numbers, files).readFields(root, appearance);
    return appearance;
}

} // namespace pixelplumb
