// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/solidreader.h"

#include "core/scan/choicenames.h"
#include "core/scene/appearancenames.h"
#include "core/scene/fields/attributereader.h"
#include "core/scene/files/scenelimits.h"
#include "core/scene/text/colourreader.h"
#include "core/space/polygonshape.h"
#include "core/space/spacevector.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

const QString solidColourKey = "color";
const QString solidColoursKey = "colors";
const QString solidMaterialKey = "material";
const QString segmentsKey = "segments";

QStringList keysOf(SolidKind kind)
{
    const QStringList keys = {nameText(nameOf(kind)), solidMaterialKey, solidColourKey};
    switch (kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
        return keys + QStringList{solidColoursKey, "uv", "normals"};
    case SolidKind::Plane:
        break;
    case SolidKind::Sphere:
        return keys + QStringList{"radius", segmentsKey};
    case SolidKind::Patch:
        return keys + QStringList{segmentsKey};
    case SolidKind::Mesh:
        return keys + QStringList{"at", "scale", "rotate"};
    }
    return keys;
}

} // namespace

Solid SolidReader::read(const JsonNode &primitive, SolidKind kind)
{
    m_json.expectObject(primitive, keysOf(kind) + QStringList{"hidden"});
    Solid solid;
    solid.kind = kind;
    solid.material = readMaterialName(m_json, primitive[solidMaterialKey], m_materials);
    if (const JsonNode node = primitive[solidColourKey]; !node.isMissing()) {
        const BlendedColour colour = readBlendedColour(m_json, node);
        solid.colour = colour.colour;
        solid.alpha = colour.alpha;
    }
    switch (kind) {
    case SolidKind::Triangle3:
    case SolidKind::Polygon3:
        readCorners(primitive, solid);
        break;
    case SolidKind::Plane:
        readPlane(primitive, solid);
        break;
    case SolidKind::Sphere:
        readSphere(primitive, solid);
        break;
    case SolidKind::Patch:
        readPatch(primitive, solid);
        break;
    case SolidKind::Mesh:
        readMesh(primitive, solid);
        break;
    }
    return solid;
}

void SolidReader::readCorners(const JsonNode &primitive, Solid &solid)
{
    const JsonNode node = primitive[nameText(nameOf(solid.kind))];
    const bool isTriangle = solid.kind == SolidKind::Triangle3;
    const std::vector<JsonNode> corners = isTriangle ? m_json.array(node, 3) : m_json.array(node);
    if (corners.size() < 3)
        m_json.fail(node, describe(node), "an array of 3 points or more");
    for (const JsonNode &corner : corners) {
        if (m_json.hasFailed())
            return;
        solid.corners.push_back({m_numbers.vector(corner), solid.colour, solid.alpha});
    }
    if (!isTriangle)
        checkPolygon(node, solid);
    const auto count = qsizetype(solid.corners.size());
    readCornerColours(primitive, solid);
    if (const JsonNode texture = primitive["uv"]; !texture.isMissing()) {
        const std::vector<JsonNode> points = m_json.array(texture, count);
        for (std::size_t i = 0; i < points.size() && !m_json.hasFailed(); ++i) {
            const std::vector<JsonNode> numbers = m_json.array(points[i], 2);
            solid.corners[i].texture = {m_numbers.real(numbers[0]), m_numbers.real(numbers[1])};
        }
    }
    if (const JsonNode normals = primitive["normals"]; !normals.isMissing()) {
        const std::vector<JsonNode> directions = m_json.array(normals, count);
        for (std::size_t i = 0; i < directions.size() && !m_json.hasFailed(); ++i) {
            solid.corners[i].normal = m_numbers.vector(directions[i]);
            if (solid.corners[i].normal == Vector3())
                m_json.fail(directions[i], "a normal of length 0", "a direction");
        }
    }
    // The corners carry the colour instead.
    solid.colour = Solid().colour;
    solid.alpha = Solid().alpha;
}

void SolidReader::readCornerColours(const JsonNode &primitive, Solid &solid)
{
    const JsonNode node = primitive[solidColoursKey];
    if (node.isMissing())
        return;
    if (!primitive[solidColourKey].isMissing())
        m_json.fail(node, "both color and colors", "one of the two");
    const std::vector<JsonNode> colours = m_json.array(node, qsizetype(solid.corners.size()));
    for (std::size_t i = 0; i < colours.size() && !m_json.hasFailed(); ++i) {
        const BlendedColour colour = readBlendedColour(m_json, colours[i]);
        solid.corners[i].colour = colour.colour;
        solid.corners[i].alpha = colour.alpha;
    }
}

void SolidReader::checkPolygon(const JsonNode &node, const Solid &solid)
{
    if (m_json.hasFailed())
        return;
    switch (shapeOf(solid.corners)) {
    case PolygonShape::Convex:
        break;
    case PolygonShape::Flattened:
        m_json.fail(node, "corners on one line", "a polygon with an area");
        break;
    case PolygonShape::Bent:
        m_json.fail(node, "corners that are not in one plane", "a polygon in one plane");
        break;
    case PolygonShape::Concave:
        m_json.fail(node, "a polygon that is not convex",
                    "a convex one; others are made of several");
        break;
    }
}

void SolidReader::readPlane(const JsonNode &primitive, Solid &solid)
{
    const JsonNode node = primitive[nameText(nameOf(solid.kind))];
    const std::vector<JsonNode> points = m_json.array(node, 3);
    for (const JsonNode &point : points)
        solid.corners.push_back({m_numbers.vector(point)});
    if (!m_json.hasFailed() && shapeOf(solid.corners) == PolygonShape::Flattened)
        m_json.fail(node, "three points on one line", "three that span a plane");
}

void SolidReader::readSphere(const JsonNode &primitive, Solid &solid)
{
    const JsonNode node = primitive[nameText(nameOf(solid.kind))];
    solid.corners = {{m_numbers.vector(node)}};
    solid.radius = m_numbers.positive(primitive["radius"], "a radius");
    readSegments(primitive[segmentsKey], {3, 2}, solid);
    checkReach(node, solid.corners.front().position, solid.radius);
}

void SolidReader::readPatch(const JsonNode &primitive, Solid &solid)
{
    const std::vector<JsonNode> rows = m_json.array(primitive[nameText(nameOf(solid.kind))], 4);
    for (const JsonNode &row : rows) {
        const std::vector<JsonNode> points = m_json.array(row, 4);
        for (const JsonNode &point : points)
            solid.corners.push_back({m_numbers.vector(point)});
    }
    solid.segments = {8, 8};
    readSegments(primitive[segmentsKey], {1, 1}, solid);
}

void SolidReader::readSegments(const JsonNode &node, const std::array<int, 2> &least, Solid &solid)
{
    if (node.isMissing())
        return;
    const std::vector<JsonNode> counts = m_json.array(node, 2);
    for (std::size_t i = 0; i < 2; ++i)
        solid.segments[i] = int(m_json.integer(counts[i], least[i], mostSegments));
}

void SolidReader::readMesh(const JsonNode &primitive, Solid &solid)
{
    const JsonNode node = primitive[nameText(nameOf(solid.kind))];
    const QString name = m_json.string(node);
    if (m_json.hasFailed())
        return;
    const auto mesh = m_files.mesh(name);
    if (!mesh) {
        m_json.fail(node, u"%1: %2"_s.arg(mesh.error().place, mesh.error().found),
                    mesh.error().expected);
        return;
    }
    solid.mesh = *mesh;
    if (const JsonNode at = primitive["at"]; !at.isMissing())
        solid.at = m_numbers.vector(at);
    if (const JsonNode scale = primitive["scale"]; !scale.isMissing())
        solid.scale = m_numbers.positive(scale, "a scale");
    if (const JsonNode rotate = primitive["rotate"]; !rotate.isMissing())
        solid.rotate = m_numbers.vector(rotate);
    double radius = 0;
    for (const SolidCorner &corner : solid.mesh->corners)
        radius = std::max(radius, lengthOf(SpaceVector<double>(corner.position)));
    checkReach(node, solid.at, solid.scale * radius);
}

void SolidReader::checkReach(const JsonNode &node, const Vector3 &centre, double radius)
{
    double reach = 0;
    for (const double coordinate : centre)
        reach = std::max(reach, std::abs(coordinate) + radius);
    if (reach > double(largestAttributeValue))
        m_json.fail(node, u"it reaches to %1"_s.arg(reach),
                    u"all of it within ±%1"_s.arg(largestAttributeValue));
}

} // namespace pixelplumb
