// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/primitivewriter.h"

#include "core/scene/fields/attributereader.h"
#include "core/scene/shapenames.h"
#include "core/scene/text/colourtext.h"
#include "core/scene/text/coordinatetext.h"
#include "core/scene/text/jsonreader.h"

#include <span>

namespace pixelplumb {

namespace {

QByteArray number(std::int64_t units, const NumberFormat &format)
{
    const QByteArray text = numberText(units, format).toUtf8();
    return text.contains('/') ? '"' + text + '"' : text;
}

QByteArray coordinate(Lattice units) { return number(units, coordinateFormat); }

QByteArray points(std::span<const Vertex> vertices)
{
    QByteArray text = "[";
    for (const Vertex &vertex : vertices)
        text += (text.size() > 1 ? ", " : "") + jsonPointText(vertex.position);
    return text + ']';
}

QByteArray colour(const Colour &colour) { return '"' + colourText(colour).toUtf8() + '"'; }

/// A colour for each vertex.
QByteArray colours(std::span<const Vertex> vertices, const TriangleAttributes *attributes = nullptr)
{
    QByteArray text;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::uint8_t alpha = attributes != nullptr ? attributes->vertices[i].alpha : 255;
        text += (text.isEmpty() ? "\"" : ", \"")
            + colourText(BlendedColour{vertices[i].colour, alpha}).toUtf8() + '"';
    }
    return ", \"colors\": [" + text + ']';
}

/// The first vertex's colour, shared by all.
QByteArray colourOfAll(const Shape &shape)
{
    const Colour first = shape.vertices.empty() ? Colour() : shape.vertices.front().colour;
    return ", \"color\": " + colour(first);
}

QByteArray fillText(const Shape &shape)
{
    const std::span<const FillName> fills = fillNamesOf(shape.kind);
    QByteArray name = fills.front().name;
    for (const FillName &each : fills) {
        if (each.fill == shape.fill)
            name = each.name;
    }
    return ", \"fill\": \"" + name + '"';
}

QByteArray roundText(const Shape &shape)
{
    const LatticePoint centre = shape.vertices[0].position;
    const LatticePoint corner = shape.vertices[1].position;
    const QByteArray radiusX = coordinate(corner.x - centre.x);
    const QByteArray radiusY = coordinate(corner.y - centre.y);
    const QByteArray radius = shape.kind == PrimitiveKind::Circle
        ? ", \"radius\": " + radiusX
        : ", \"radii\": [" + radiusX + ", " + radiusY + ']';
    return "{ \"centre\": " + jsonPointText(centre) + radius + " }";
}

/// The vertices; with several parts, their arrays under a key.
QByteArray partsText(const Shape &shape, const char *key)
{
    if (shape.laterContours.empty())
        return points(shape.vertices);
    QByteArray text = QByteArray("{ \"") + key + "\": [";
    std::size_t first = 0;
    for (std::size_t contour = 0; contour <= shape.laterContours.size(); ++contour) {
        const std::size_t end = contour < shape.laterContours.size() ? shape.laterContours[contour]
                                                                     : shape.vertices.size();
        text += (contour > 0 ? ", " : "")
            + points(std::span(shape.vertices).subspan(first, end - first));
        first = end;
    }
    return text + "] }";
}

/// What follows the key that names the shape.
QByteArray valueText(const Shape &shape)
{
    switch (shape.kind) {
    case PrimitiveKind::Point:
    case PrimitiveKind::Line:
        return points(shape.vertices) + colours(shape.vertices);
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return roundText(shape) + colourOfAll(shape) + fillText(shape);
    case PrimitiveKind::Polygon:
        return partsText(shape, "contours") + colourOfAll(shape) + fillText(shape);
    case PrimitiveKind::Text:
        return quotedText(QByteArray::fromStdString(shape.text))
            + ", \"at\": " + jsonPointText(shape.vertices.front().position)
            + ", \"height\": " + coordinate(shape.textHeight) + colourOfAll(shape);
    case PrimitiveKind::Bezier:
        return partsText(shape, "path") + colourOfAll(shape)
            + (shape.fill == ShapeFill::Outline ? QByteArray() : fillText(shape));
    case PrimitiveKind::Triangle: // never a shape
        break;
    }
    return points(shape.vertices) + colourOfAll(shape);
}

} // namespace

QByteArray jsonPointText(const LatticePoint &position)
{
    return '[' + coordinate(position.x) + ", " + coordinate(position.y) + ']';
}

QByteArray jsonAttributeText(Attribute value) { return number(value, attributeFormat); }

QByteArray jsonAttributeText(std::span<const Attribute> values)
{
    QByteArray text = "[";
    for (const Attribute value : values)
        text += (text.size() > 1 ? ", " : "") + jsonAttributeText(value);
    return text + ']';
}

QByteArray primitiveText(const Triangle &triangle, const TriangleAttributes *attributes,
                         const std::vector<Material> &materials)
{
    return "{ \"triangle\": " + points(triangle.vertices) + colours(triangle.vertices, attributes)
        + (attributes != nullptr ? attributesText(*attributes, materials) : QByteArray()) + " }";
}

QByteArray primitiveText(const Shape &shape)
{
    return "{ \"" + keyOf(shape.kind).toUtf8() + "\": " + valueText(shape) + " }";
}

QByteArray primitiveText(const HiddenPrimitive &hidden, const std::vector<Material> &materials)
{
    QByteArray text;
    if (const auto *shape = std::get_if<Shape>(&hidden.primitive)) {
        text = primitiveText(*shape);
    } else {
        const auto &[triangle, attributes] = std::get<HiddenTriangle>(hidden.primitive);
        text = primitiveText(triangle, &attributes, materials);
    }
    text.chop(2); // " }"
    return text + ", \"hidden\": true }";
}

QByteArray jsonRealText(double value) { return numberText(value).toUtf8(); }

QByteArray jsonRealsText(std::span<const double> values)
{
    QByteArray text = "[";
    for (const double value : values)
        text += (text.size() > 1 ? ", " : "") + jsonRealText(value);
    return text + ']';
}

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

} // namespace pixelplumb
