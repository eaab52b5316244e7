// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/fieldtexts.h"

#include "core/scene/text/coordinatetext.h"

namespace pixelplumb {

namespace {

QByteArray numberIn(std::int64_t units, const NumberFormat &format)
{
    const QByteArray text = numberText(units, format).toUtf8();
    return text.contains('/') ? '"' + text + '"' : text;
}

/// Elements in brackets, each on its own line.
QByteArray block(const QByteArrayList &lines, char open, char close)
{
    return open + ("\n        " + lines.join(",\n        ") + "\n    ") + close;
}

} // namespace

QByteArray quotedText(const QByteArray &utf8)
{
    QByteArray text = "\"";
    for (const char character : utf8) {
        if (character == '"' || character == '\\')
            text += '\\';
        if (static_cast<unsigned char>(character) < 0x20)
            text += "\\u" + QByteArray::number(int(character), 16).rightJustified(4, '0');
        else
            text += character;
    }
    return text + '"';
}

QByteArray FieldTexts::textOf(Attribute number) const { return numberIn(number, attributeFormat); }

QByteArray FieldTexts::textOf(const AboveZero<const Lattice> &field) const
{
    return numberIn(field.number, coordinateFormat);
}

QByteArray FieldTexts::textOf(const LatticePoint &point) const
{
    return list({numberIn(point.x, coordinateFormat), numberIn(point.y, coordinateFormat)});
}

QByteArray FieldTexts::textOf(const FirstPixelOf<const FrameSpec> &field) const
{
    const auto &[column, row] = std::pair(field.frame.firstColumn, field.frame.firstRow);
    return column == 0 && row == 0 ? QByteArray()
                                   : list({QByteArray::number(column), QByteArray::number(row)});
}

QByteArray FieldTexts::textOf(const ColourOfAll<const Vertex> &field) const
{
    return textOf(field.vertices.empty() ? Colour() : field.vertices.front().colour);
}

/// With several parts, their arrays under a key.
QByteArray FieldTexts::textOf(const PointsOf<const Shape> &field) const
{
    const std::span<const Vertex> vertices = field.shape.vertices;
    if (field.shape.laterContours.empty())
        return pointsText(vertices);
    QByteArrayList parts;
    std::size_t first = 0;
    for (const std::size_t next : field.shape.laterContours) {
        parts.append(pointsText(vertices.subspan(first, next - first)));
        first = next;
    }
    parts.append(pointsText(vertices.subspan(first)));
    return QByteArray("{ \"") + field.partsKey + "\": " + list(parts) + " }";
}

QByteArray FieldTexts::textOf(const RoundOf<const Shape> &field) const
{
    const LatticePoint centre = field.shape.vertices[0].position;
    const LatticePoint corner = field.shape.vertices[1].position;
    return inBraces(
        of(RoundFields{field.shape.kind, centre, {corner.x - centre.x, corner.y - centre.y}}));
}

/// Nothing for an open curve.
QByteArray FieldTexts::textOf(const FillOf<const Shape> &field) const
{
    const auto &[kind, fill] = std::pair(field.shape.kind, field.shape.fill);
    if (kind == PrimitiveKind::Bezier && fill == ShapeFill::Outline)
        return {};
    const std::span<const FillName> fills = fillNamesOf(kind);
    const auto named = std::ranges::find(fills, fill, &FillName::fill);
    return quotedText(named == fills.end() ? fills.front().name : named->name);
}

QByteArray FieldTexts::textOf(const MaterialOf<const int> &field) const
{
    return field.index == noMaterial ? QByteArray()
                                     : textOf(m_materials[std::size_t(field.index)].name);
}

QByteArray FieldTexts::textOf(VariantSet variants) const
{
    QByteArrayList names;
    for (const Variant variant : variantsIn(variants))
        names.append(quotedText(nameText(nameOf(variant)).toUtf8()));
    return names.isEmpty() ? QByteArray() : list(names);
}

QByteArray FieldTexts::textOf(const std::vector<Material> &materials) const
{
    QByteArrayList lines;
    for (const Material &material : materials) {
        const QByteArrayList fields = ofOthersThanDefaults(material);
        lines.append(textOf(material.name) + ": " + (fields.isEmpty() ? "{}" : inBraces(fields)));
    }
    return block(lines, '{', '}');
}

QByteArray FieldTexts::textOf(const std::vector<Light> &lights) const
{
    QByteArrayList lines;
    for (const Light &light : lights)
        lines.append(inBraces(of(light)));
    return block(lines, '[', ']');
}

} // namespace pixelplumb
