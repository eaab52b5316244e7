// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapeediting.h"

#include <algorithm>
#include <cstdlib>

namespace pixelplumb {

namespace {

constexpr Lattice placedTextHeight = 24 * unitsPerPixel;

bool isRound(PrimitiveKind kind)
{
    return kind == PrimitiveKind::Circle || kind == PrimitiveKind::Ellipse;
}

/// The corner of the bounding box, above and to the right of the centre.
LatticePoint cornerOf(PrimitiveKind kind, const LatticePoint &centre, const LatticePoint &wish)
{
    Lattice right = std::max<Lattice>(1, std::abs(wish.x - centre.x));
    Lattice up = std::max<Lattice>(1, std::abs(wish.y - centre.y));
    if (kind == PrimitiveKind::Circle)
        right = up = std::max(right, up);
    return {centre.x + right, centre.y + up};
}

/// For a Bézier path: at a joint where a piece ends or begins, the coinciding vertex of the
/// neighbouring piece; none where the pieces do not meet.
std::optional<std::size_t> besideJoint(const Shape &path, std::size_t vertex)
{
    if (path.kind != PrimitiveKind::Bezier || path.laterContours.empty())
        return std::nullopt;
    const std::size_t count = path.vertices.size();
    const auto begins = [&](std::size_t index) {
        return index == 0 || std::ranges::count(path.laterContours, index) > 0;
    };
    const std::size_t before = (vertex + count - 1) % count;
    const std::size_t after = (vertex + 1) % count;
    std::optional<std::size_t> beside;
    if (begins(vertex))
        beside = before;
    else if (begins(after))
        beside = after;
    const bool meets = beside && path.vertices[*beside].position == path.vertices[vertex].position;
    return meets ? beside : std::nullopt;
}

} // namespace

std::optional<std::size_t> placedVertexCount(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
        return 3;
    case PrimitiveKind::Point:
    case PrimitiveKind::Text:
        return 1;
    case PrimitiveKind::Line:
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
        return 2;
    case PrimitiveKind::Bezier:
        return 4;
    case PrimitiveKind::Polygon:
        break;
    }
    return std::nullopt;
}

Shape shapeFrom(PrimitiveKind kind, std::span<const Vertex> vertices,
                std::span<const ShapeFill> fills)
{
    Shape shape;
    shape.kind = kind;
    shape.vertices.assign(vertices.begin(), vertices.end());
    if (isRound(kind))
        shape.vertices[1].position
            = cornerOf(kind, shape.vertices[0].position, shape.vertices[1].position);
    if (!fills.empty())
        shape.fill = fills.front();
    if (kind == PrimitiveKind::Text) {
        shape.text = "Ag";
        shape.textHeight = placedTextHeight;
        shape.fill = ShapeFill::NonZero;
    }
    return shape;
}

void moveVertex(Shape &shape, std::size_t vertex, const LatticePoint &position)
{
    LatticePoint &moved = shape.vertices[vertex].position;
    if (const std::optional<std::size_t> beside = besideJoint(shape, vertex))
        shape.vertices[*beside].position = position;
    if (!isRound(shape.kind)) {
        moved = position;
        return;
    }
    LatticePoint &corner = shape.vertices[1].position;
    if (vertex == 1) {
        const LatticePoint &centre = shape.vertices[0].position;
        LatticePoint wish = position;
        // In a circle's square, the one coordinate that changes takes the other along.
        if (shape.kind == PrimitiveKind::Circle && wish.y == corner.y)
            wish.y = centre.y + (wish.x - centre.x);
        else if (shape.kind == PrimitiveKind::Circle && wish.x == corner.x)
            wish.x = centre.x + (wish.y - centre.y);
        corner = cornerOf(shape.kind, centre, wish);
        return;
    }
    corner = {corner.x + position.x - moved.x, corner.y + position.y - moved.y};
    moved = position;
}

} // namespace pixelplumb
