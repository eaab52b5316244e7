// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/choicenames.h"
#include "core/scene/fields/primitivefields.h"
#include "core/scene/fields/referredfiles.h"
#include "core/scene/text/colourtext.h"
#include "core/scene/text/jsonreader.h"

#include <QByteArrayList>

#include <algorithm>

namespace pixelplumb {

/// A text in quotation marks, escaped for JSON.
QByteArray quotedText(const QByteArray &utf8);

/// Writes a scene's parts by their lists of fields. A field of which there is nothing to say has an
/// empty text.
class FieldTexts {
public:
    /// Pictures and meshes are named relative to the folder; empty: as the scene names them. The
    /// materials are the scene's.
    explicit FieldTexts(const QString &folder = {}, std::span<const Material> materials = {})
        : m_folder(folder)
        , m_materials(materials)
    {
    }

    /// "\"name\": value" of each field.
    template <class Part>
    QByteArrayList of(const Part &part) const
    {
        QByteArrayList fields;
        eachField(part, [&](const char *name, const auto &value) {
            if (const QByteArray text = textOf(value); !text.isEmpty())
                fields.append('"' + QByteArray(name) + "\": " + text);
        });
        return fields;
    }
    /// Without those that have their defaults.
    template <class Part>
    QByteArrayList ofOthersThanDefaults(const Part &part) const
    {
        QByteArrayList fields = of(part);
        const QByteArrayList defaults = of(Part());
        fields.removeIf([&](const QByteArray &field) { return defaults.contains(field); });
        return fields;
    }

    static QByteArray inBraces(const QByteArrayList &fields)
    {
        return "{ " + fields.join(", ") + " }";
    }

    template <class Value>
    QByteArray textOf(const Required<Value> &field) const
    {
        return textOf(field.value);
    }
    template <class Value>
    QByteArray textOf(const std::optional<Value> &value) const
    {
        return value ? textOf(*value) : QByteArray();
    }
    /// Names are quoted, except those that are numbers.
    template <class Choice, class Choices>
    QByteArray textOf(const ChoiceOf<Choice, Choices> &field) const
    {
        const QByteArray name = nameText(nameOf(field.choice)).toUtf8();
        return name[0] >= '0' && name[0] <= '9' ? name : quotedText(name);
    }
    template <class Number>
    QByteArray textOf(const NumberWithin<Number> &field) const
    {
        return QByteArray::number(field.number);
    }
    template <class Number>
    QByteArray textOf(const NumberBetween<Number> &field) const
    {
        return textOf(field.number);
    }
    QByteArray textOf(const AboveZero<const Lattice> &field) const;
    QByteArray textOf(const AboveZero<const double> &field) const { return textOf(field.number); }
    /// Of an array, whose values may be fields.
    template <class Values>
    requires(std::tuple_size<Values>::value > 0) QByteArray textOf(const Values &values)
    const
    {
        QByteArrayList texts;
        for (const auto &value : values)
            texts.append(textOf(value));
        return list(texts);
    }
    template <class Vertex, class Value>
    QByteArray textOf(const Required<OfEach<Vertex, Value>> &field) const
    {
        return eachText(field.value);
    }
    template <class Vertex, class Value>
    QByteArray textOf(const OfEach<Vertex, Value> &field) const
    {
        const auto hasDefault = [value = field.value](const Vertex &vertex) {
            return vertex.*value == Vertex().*value;
        };
        return std::ranges::all_of(field.vertices, hasDefault) ? QByteArray() : eachText(field);
    }
    template <class Vertex, class Blended>
    QByteArray textOf(const Required<BlendedColours<Vertex, Blended>> &field) const
    {
        return list(coloursOf(field.value));
    }
    template <class Vertex, class Blended>
    QByteArray textOf(const BlendedColours<Vertex, Blended> &field) const
    {
        const QByteArrayList colours = coloursOf(field);
        return isOne(colours) ? QByteArray() : list(colours);
    }
    /// Nothing where they differ; shapes have one colour alone.
    template <class Blended>
    QByteArray textOf(const ColourOfAll<Blended> &field) const
    {
        const QByteArrayList colours = coloursOf(BlendedColours{field.vertices, field.vertices});
        return isOne(colours) ? colours.front() : QByteArray();
    }
    QByteArray textOf(const ColourOfAll<const Vertex> &field) const;
    QByteArray textOf(const FirstPixelOf<const FrameSpec> &field) const;
    QByteArray textOf(const PointsOf<const Shape> &field) const;
    QByteArray textOf(const RoundOf<const Shape> &field) const;
    QByteArray textOf(const FillOf<const Shape> &field) const;
    QByteArray textOf(const MaterialOf<const int> &field) const;
    QByteArray textOf(const std::string &text) const
    {
        return quotedText(QByteArray::fromStdString(text));
    }
    QByteArray textOf(double number) const { return numberText(number).toUtf8(); }
    QByteArray textOf(Attribute number) const;
    QByteArray textOf(const LatticePoint &point) const;
    QByteArray textOf(const Colour &colour) const
    {
        return quotedText(colourText(colour).toUtf8());
    }
    QByteArray textOf(VariantSet variants) const;
    /// Of a picture or a mesh, which may be missing.
    template <class File>
    QByteArray textOf(const std::shared_ptr<const File> &file) const
    {
        return file ? quotedText(nameInFolder(file->name, m_folder).toUtf8()) : QByteArray();
    }
    QByteArray textOf(const std::vector<Material> &materials) const;
    QByteArray textOf(const std::vector<Light> &lights) const;
    QByteArray textOf(const FrameSpec &frame) const { return inBraces(of(frame)); }
    QByteArray textOf(const Camera &camera) const { return inBraces(of(camera)); }
    QByteArray textOf(const Motion &motion) const { return inBraces(of(motion)); }

private:
    static QByteArray list(const QByteArrayList &values) { return '[' + values.join(", ") + ']'; }
    static bool isOne(const QByteArrayList &values)
    {
        return values.count(values.front()) == values.size();
    }
    template <class Vertex, class Value>
    QByteArray eachText(const OfEach<Vertex, Value> &field) const
    {
        QByteArrayList values;
        for (const Vertex &vertex : field.vertices)
            values.append(textOf(vertex.*field.value));
        return list(values);
    }
    template <class Vertex, class Blended>
    static QByteArrayList coloursOf(const BlendedColours<Vertex, Blended> &field)
    {
        QByteArrayList colours;
        for (std::size_t i = 0; i < field.vertices.size(); ++i)
            colours.append(quotedText(
                colourText(BlendedColour{field.vertices[i].colour, field.opacities[i].alpha})
                    .toUtf8()));
        return colours;
    }
    QByteArray pointsText(std::span<const Vertex> vertices) const
    {
        return eachText(OfEach{vertices, &Vertex::position});
    }

    QString m_folder;
    std::span<const Material> m_materials;
};

} // namespace pixelplumb
