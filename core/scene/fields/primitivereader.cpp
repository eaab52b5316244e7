// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/primitivereader.h"

#include "core/scene/appearancenames.h"
#include "core/scene/fields/attributereader.h"
#include "core/scene/fields/solidreader.h"
#include "core/scene/files/scenelimits.h"
#include "core/scene/shapenames.h"
#include "core/scene/text/choicereader.h"
#include "core/scene/text/colourreader.h"

namespace pixelplumb {

namespace {

constexpr std::array allKinds = {
    PrimitiveKind::Triangle, PrimitiveKind::Point,  PrimitiveKind::Line,    PrimitiveKind::Circle,
    PrimitiveKind::Ellipse,  PrimitiveKind::Bezier, PrimitiveKind::Polygon, PrimitiveKind::Text};

const QString colourKey = "color";
const QString coloursKey = "colors";
const QString fillKey = "fill";
const QString hiddenKey = "hidden";

} // namespace

QStringList primitiveKeys()
{
    QStringList keys;
    for (const PrimitiveKind kind : allKinds)
        keys.append(keyOf(kind));
    return keys + namesOf(allSolidKinds);
}

void PrimitiveReader::read(const JsonNode &primitive)
{
    for (const SolidKind kind : allSolidKinds) {
        if (!primitive[nameText(nameOf(kind))].isMissing()) {
            readSolid(primitive, kind);
            return;
        }
    }
    Shape shape;
    shape.kind = kindOf(primitive);
    if (m_json.hasFailed())
        return;
    switch (shape.kind) {
    case PrimitiveKind::Triangle:
        readTriangle(primitive);
        return;
    case PrimitiveKind::Point:
        readPoints(primitive, {1, PointCount::any}, shape);
        break;
    case PrimitiveKind::Line:
        readPoints(primitive, {2, 2}, shape);
        break;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        readRound(primitive, shape);
        break;
    case PrimitiveKind::Bezier:
        readBezier(primitive, shape);
        break;
    case PrimitiveKind::Polygon:
        readPolygon(primitive, shape);
        break;
    case PrimitiveKind::Text:
        readText(primitive, shape);
        break;
    }
    if (isHidden(primitive))
        m_scene.hidden.push_back({m_scene.shapes.size(), std::move(shape)});
    else
        m_scene.shapes.push_back(std::move(shape));
}

void PrimitiveReader::expectKeys(const JsonNode &primitive, const QStringList &keys)
{
    m_json.expectObject(primitive, keys + QStringList{hiddenKey});
}

bool PrimitiveReader::isHidden(const JsonNode &primitive)
{
    const JsonNode hidden = primitive[hiddenKey];
    return !hidden.isMissing() && m_json.boolean(hidden);
}

PrimitiveKind PrimitiveReader::kindOf(const JsonNode &primitive)
{
    for (const PrimitiveKind kind : allKinds) {
        if (!primitive[keyOf(kind)].isMissing())
            return kind;
    }
    // Reports a misspelt key before the missing primitive.
    expectKeys(primitive, primitiveKeys() + QStringList{colourKey, coloursKey, fillKey});
    m_json.fail(primitive, "no primitive is named", u"one of "_s + primitiveKeys().join(u", "_s));
    return PrimitiveKind::Triangle;
}

void PrimitiveReader::readTriangle(const JsonNode &primitive)
{
    const QString key = keyOf(PrimitiveKind::Triangle);
    expectKeys(primitive, QStringList{key, coloursKey} + attributeKeys());
    if (hasShapes() || !m_scene.solids.empty())
        m_json.fail(primitive[key], "a triangle after another primitive",
                    "all triangles first: they are drawn before the others");
    Triangle triangle;
    TriangleAttributes attributes
        = readAttributes(m_json, m_numbers, primitive, m_scene.appearance.materials);
    const std::vector<JsonNode> vertices = m_json.array(primitive[key], 3);
    const std::vector<JsonNode> colours = m_json.array(primitive[coloursKey], 3);
    for (std::size_t index = 0; index < 3; ++index) {
        triangle.vertices[index].position = m_numbers.position(vertices[index]);
        const BlendedColour colour = readBlendedColour(m_json, colours[index]);
        triangle.vertices[index].colour = colour.colour;
        attributes.vertices[index].alpha = colour.alpha;
    }
    if (isHidden(primitive)) {
        m_scene.hidden.push_back({m_scene.triangles.size(), HiddenTriangle{triangle, attributes}});
        return;
    }
    if (attributes != TriangleAttributes()) {
        attributes.triangle = m_scene.triangles.size();
        m_scene.attributes.push_back(attributes);
    }
    m_scene.triangles.push_back(triangle);
}

void PrimitiveReader::readSolid(const JsonNode &primitive, SolidKind kind)
{
    const QString key = nameText(nameOf(kind));
    const JsonNode node = primitive[key];
    if (hasShapes())
        m_json.fail(node, u"a %1 after a shape of the frame"_s.arg(key),
                    "triangles, then what is seen through the camera, then shapes");
    if (!m_scene.camera)
        m_json.fail(node, u"a %1 in a scene without a camera"_s.arg(key),
                    "a key \"camera\" of the scene: { \"eye\": [0, 0, 5], … }");
    Solid solid = SolidReader(m_json, m_numbers, m_current.files, m_scene.appearance.materials)
                      .read(primitive, kind);
    solid.isHidden = isHidden(primitive);
    if (m_json.hasFailed())
        return;
    m_current.solidTriangles += triangleCount(solid);
    if (m_current.solidTriangles > mostSolidTriangles)
        m_json.fail(node, tooManyTriangles(m_current.solidTriangles), fewerTriangles());
    m_scene.solids.push_back(std::move(solid));
}

void PrimitiveReader::readPoints(const JsonNode &primitive, PointCount count, Shape &shape)
{
    const QString key = keyOf(shape.kind);
    expectKeys(primitive, {key, coloursKey});
    appendPositions(primitive[key], count, shape);
    readColours(primitive, shape);
}

void PrimitiveReader::readRound(const JsonNode &primitive, Shape &shape)
{
    const QString key = keyOf(shape.kind);
    const bool isCircle = shape.kind == PrimitiveKind::Circle;
    const QString radiusKey = isCircle ? "radius" : "radii";
    expectKeys(primitive, {key, colourKey, fillKey});
    const JsonNode node = primitive[key];
    m_json.expectObject(node, {"centre", radiusKey});
    const LatticePoint centre = m_numbers.position(node["centre"]);
    LatticePoint radii;
    if (isCircle) {
        radii.x = radii.y = m_numbers.length(node[radiusKey], "a radius");
    } else {
        const std::vector<JsonNode> both = m_json.array(node[radiusKey], 2);
        radii = {m_numbers.length(both[0], "a radius"), m_numbers.length(both[1], "a radius")};
    }
    const LatticePoint corner = {centre.x + radii.x, centre.y + radii.y};
    if (!isWithinRange(corner) || !isWithinRange({centre.x - radii.x, centre.y - radii.y}))
        m_json.fail(node, u"the %1 leaves ±%2 px"_s.arg(key, QString::number(largestPixel)),
                    "a smaller radius or another centre");
    shape.vertices = {{centre, {}}, {corner, {}}};
    shape.fill = fill(primitive[fillKey], shape.kind);
    readColourOfAll(primitive, shape);
}

void PrimitiveReader::readBezier(const JsonNode &primitive, Shape &shape)
{
    readContours(primitive, "path", "no piece", {3, 4}, shape);
    const JsonNode node = primitive[keyOf(shape.kind)];
    if (node.isObject() && shape.fill == ShapeFill::Outline)
        m_json.fail(node, "a path that is not filled",
                    "\"fill\": \"even-odd\" or \"non-zero\"; without it, one curve of three or "
                    "four points");
}

void PrimitiveReader::readPolygon(const JsonNode &primitive, Shape &shape)
{
    readContours(primitive, "contours", "no contour", {3, PointCount::any}, shape);
}

/// Points, or arrays of them under a key.
void PrimitiveReader::readContours(const JsonNode &primitive, const QString &partsKey,
                                   const QString &none, PointCount count, Shape &shape)
{
    const QString key = keyOf(shape.kind);
    expectKeys(primitive, {key, colourKey, fillKey});
    const JsonNode node = primitive[key];
    if (!node.isObject()) {
        appendPositions(node, count, shape);
    } else {
        m_json.expectObject(node, {partsKey});
        appendParts(node[partsKey], none, count, shape);
    }
    shape.fill = fill(primitive[fillKey], shape.kind);
    readColourOfAll(primitive, shape);
}

void PrimitiveReader::readText(const JsonNode &primitive, Shape &shape)
{
    const QString key = keyOf(shape.kind);
    expectKeys(primitive, {key, "at", "height", colourKey});
    const QString text = m_json.string(primitive[key]);
    countVertices(primitive[key], text.size() * qsizetype(verticesOfCharacter));
    shape.text = text.toStdString();
    shape.vertices = {{m_numbers.position(primitive["at"]), {}}};
    shape.textHeight = m_numbers.length(primitive["height"], "a height");
    // Fonts are drawn for this rule: the outlines of a letter may overlap.
    shape.fill = ShapeFill::NonZero;
    readColourOfAll(primitive, shape);
}

void PrimitiveReader::countVertices(const JsonNode &node, qsizetype more)
{
    m_current.shapeVertices += std::size_t(more);
    if (m_current.shapeVertices > mostShapeVertices)
        m_json.fail(node, tooManyVertices(m_current.shapeVertices), fewerVertices());
}

void PrimitiveReader::appendPositions(const JsonNode &node, PointCount count, Shape &shape)
{
    countVertices(node, node.size());
    if (m_json.hasFailed())
        return;
    for (const LatticePoint &position : m_numbers.positions(node, count))
        shape.vertices.push_back({position, {}});
}

void PrimitiveReader::appendParts(const JsonNode &node, const QString &none, PointCount count,
                                  Shape &shape)
{
    const std::vector<JsonNode> parts = m_json.array(node);
    if (parts.empty())
        m_json.fail(node, none, "one or more arrays of points");
    for (const JsonNode &part : parts) {
        if (m_json.hasFailed())
            return;
        if (!shape.vertices.empty())
            shape.laterContours.push_back(shape.vertices.size());
        appendPositions(part, count, shape);
    }
}

void PrimitiveReader::readColours(const JsonNode &primitive, Shape &shape)
{
    if (m_json.hasFailed())
        return;
    const std::vector<JsonNode> colours
        = m_json.array(primitive[coloursKey], qsizetype(shape.vertices.size()));
    for (std::size_t index = 0; index < shape.vertices.size() && !m_json.hasFailed(); ++index)
        shape.vertices[index].colour = readColour(m_json, colours[index]);
}

void PrimitiveReader::readColourOfAll(const JsonNode &primitive, Shape &shape)
{
    const Colour colour = readColour(m_json, primitive[colourKey]);
    for (Vertex &vertex : shape.vertices)
        vertex.colour = colour;
}

ShapeFill PrimitiveReader::fill(const JsonNode &node, PrimitiveKind kind)
{
    const std::span<const FillName> fills = fillNamesOf(kind);
    if (node.isMissing())
        return fills.front().fill;
    QStringList names;
    for (const FillName &each : fills) {
        names.append(QString::fromLatin1(each.name));
        if (node.toString() == names.back())
            return each.fill;
    }
    m_json.fail(node, describe(node), u"one of "_s + names.join(u", "_s));
    return fills.front().fill;
}

} // namespace pixelplumb
