// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/effects/bordercrossing.h"

#include "core/scan/edgeteststate.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Of a bounding box, its boundary included.
BorderCrossing crossingOfBox(const SampleBox &box, const FrameView &frame)
{
    const SampleBox inside = intersection(box, samplesOf(frame));
    if (inside.isEmpty())
        return BorderCrossing::Outside;
    const bool isWhole = inside.firstX == box.firstX && inside.endX == box.endX
        && inside.firstY == box.firstY && inside.endY == box.endY;
    return isWhole ? BorderCrossing::Within : BorderCrossing::MayCross;
}

/// Whether an edge of the triangle has the frame's first and last samples all on its outer side.
bool isApart(const Triangle &triangle, const FrameView &frame)
{
    const std::array<LatticePoint, 4> corners
        = {latticePixel(frame.firstColumn, frame.firstRow),
           latticePixel(frame.endColumn() - 1, frame.firstRow),
           latticePixel(frame.firstColumn, frame.endRow() - 1),
           latticePixel(frame.endColumn() - 1, frame.endRow() - 1)};
    const Int128 area = doubledArea(triangle);
    for (std::size_t i = 0; i < 3 && area != 0; ++i) {
        const LatticePoint &a = triangle.vertices[i].position;
        const LatticePoint &b = triangle.vertices[(i + 1) % 3].position;
        const bool isParting = std::ranges::all_of(corners, [&](const LatticePoint &corner) {
            const Int128 side = doubledArea(a, b, corner);
            return area > 0 ? side < 0 : side > 0;
        });
        if (isParting)
            return true;
    }
    return false;
}

/// A box that holds the shape, from its vertices; of a text, which is as long as its font makes it,
/// a generous one.
SampleBox boxAround(const Shape &shape)
{
    Lattice left = largestCoordinate, right = -largestCoordinate;
    Lattice low = largestCoordinate, high = -largestCoordinate;
    const auto take = [&](Lattice x, Lattice y) {
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
    };
    for (const Vertex &vertex : shape.vertices)
        take(vertex.position.x, vertex.position.y);
    const bool isRound
        = shape.kind == PrimitiveKind::Circle || shape.kind == PrimitiveKind::Ellipse;
    if (isRound && shape.vertices.size() == 2) {
        const LatticePoint &centre = shape.vertices[0].position;
        const LatticePoint &corner = shape.vertices[1].position;
        take(2 * centre.x - corner.x, 2 * centre.y - corner.y);
    }
    if (shape.kind == PrimitiveKind::Text) {
        const Lattice height = 2 * absolute(shape.textHeight);
        const Lattice length = height * Lattice(shape.text.size());
        take(left - height, low - height);
        take(right + length, high + height);
    }
    return {floorPixel(left), ceilPixel(right) + 1, floorPixel(low), ceilPixel(high) + 1};
}

} // namespace

BorderCrossing borderCrossingOf(const Triangle &triangle, const FrameView &frame)
{
    const BorderCrossing crossing = crossingOfBox(boundingBoxOf(triangle), frame);
    if (crossing != BorderCrossing::MayCross)
        return crossing;
    return isApart(triangle, frame) ? BorderCrossing::Outside : BorderCrossing::Crosses;
}

BorderCrossing borderCrossingOf(const Shape &shape, const FrameView &frame)
{
    if (shape.vertices.empty())
        return BorderCrossing::Outside;
    const BorderCrossing crossing = crossingOfBox(boxAround(shape), frame);
    if (crossing != BorderCrossing::MayCross || shape.kind == PrimitiveKind::Text)
        return crossing;
    // From a vertex within to one beyond it crosses somewhere; a circle's vertices are none of its
    // points.
    const auto isWithin = [&](const Vertex &vertex) {
        return frame.contains(ceilPixel(vertex.position.x), ceilPixel(vertex.position.y))
            && frame.contains(floorPixel(vertex.position.x), floorPixel(vertex.position.y));
    };
    const auto within = std::ranges::count_if(shape.vertices, isWithin);
    const bool passesVertices = shape.kind == PrimitiveKind::Line
        || shape.kind == PrimitiveKind::Polygon || shape.kind == PrimitiveKind::Point;
    return passesVertices && within > 0 && std::size_t(within) < shape.vertices.size()
        ? BorderCrossing::Crosses
        : BorderCrossing::MayCross;
}

} // namespace pixelplumb
