// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

/// Edge walking row by row (Rasterization slides and Scan Conversion slides, "Edge Walking") is the
/// column scan of the plane turned by a quarter to (u, v) = (−y, x): columns from left to right are
/// rows from the highest y to the lowest, and rules, trapezoids and increments are the column
/// scan's own. The rule (±ε², +ε) there is (+ε, ∓ε²) here: top-left, with the upper signs where y
/// points up.
namespace pixelplumb {

constexpr LatticePoint turned(const LatticePoint &point) { return {-point.y, point.x}; }

/// Keeps only the extreme vertices, in (x, y) order, of a triangle of zero area, which lies between
/// them by design: where vertices coincide, turning could change their order.
constexpr Triangle betweenExtremes(const Triangle &triangle)
{
    Triangle result = triangle;
    if (doubledArea(triangle) == 0) {
        const std::array<int, 3> order = sortedByColumn(triangle);
        result.vertices[std::size_t(order[1])] = result.vertices[std::size_t(order[2])];
    }
    return result;
}

constexpr Triangle turned(const Triangle &triangle)
{
    Triangle result = triangle;
    for (Vertex &vertex : result.vertices)
        vertex.position = turned(vertex.position);
    return result;
}

/// A frame seen in (u, v): each row of the frame is a column, the highest row first.
struct TurnedView {
    FrameView frame;
    std::int64_t firstColumn = 0; ///< −(the highest row)
    std::int64_t firstRow = 0;
    std::ptrdiff_t stride = 1; ///< pixels from v to v + 1: along the row

    explicit TurnedView(FrameView of)
        : frame(of)
        , firstColumn(1 - of.endRow())
        , firstRow(of.firstColumn)
    {
    }

    std::int64_t endColumn() const { return firstColumn + frame.height; }
    std::int64_t endRow() const { return firstRow + frame.width; }
    QRgb *at(std::int64_t u, std::int64_t v) const { return frame.at(v, -u); }
};

} // namespace pixelplumb
