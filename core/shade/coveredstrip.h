// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/shade/rowrun.h"

#include <algorithm>

namespace pixelplumb {

/// The rows of one column of pixel squares, half a pixel to every side of the sample, that a
/// triangle meets, and those that it covers completely.
struct CoveredStrip {
    RowRun met;
    RowRun whole; ///< within `met`; empty where there are none
};

/// The rows at column x of a triangle with area, P0 P1 P2 sorted by x.
inline CoveredStrip coveredStrip(const std::array<LatticePoint, 3> &corners, std::int64_t x)
{
    const LatticePoint &p0 = corners[0];
    const LatticePoint &p1 = corners[1];
    const LatticePoint &p2 = corners[2];
    const Lattice left = x * unitsPerPixel - halfPixel;
    const Lattice right = x * unitsPerPixel + halfPixel;
    struct Border {
        Int128 low = 0, high = 0; ///< where the triangle meets a vertical line, ⌊256·y⌋ and ⌈256·y⌉
    };
    const auto onEdge = [](const LatticePoint &a, const LatticePoint &b, Lattice at) -> Border {
        const Int128 width = b.x - a.x;
        const Int128 y = a.y * width + Int128(at - a.x) * (b.y - a.y);
        return {floorDivide<Int128>(y, width), ceilDivide<Int128>(y, width)};
    };
    /// `at` is strictly inside the triangle's columns, or at one of their ends.
    const auto borderAt = [&](Lattice at) -> Border {
        const Border longEdge = p0.x == p2.x ? Border{p0.y, p2.y} : onEdge(p0, p2, at);
        Border shortEdge;
        if (at < p1.x || p1.x == p2.x)
            shortEdge = p0.x == p1.x ? Border{std::min(p0.y, p1.y), std::max(p0.y, p1.y)}
                                     : onEdge(p0, p1, at);
        else
            shortEdge = onEdge(p1, p2, at);
        return {std::min(longEdge.low, shortEdge.low), std::max(longEdge.high, shortEdge.high)};
    };
    /// The part surely inside: between the edges, rounded inward.
    const auto innerAt = [&](Lattice at) -> Border {
        const Border longEdge = onEdge(p0, p2, at);
        const Border shortEdge
            = at < p1.x || p1.x == p2.x ? onEdge(p0, p1, at) : onEdge(p1, p2, at);
        if (longEdge.low + longEdge.high < shortEdge.low + shortEdge.high)
            return {longEdge.high, shortEdge.low};
        return {shortEdge.high, longEdge.low};
    };
    Border outer = borderAt(std::max(left, p0.x));
    const auto widen = [&outer](const Border &border) {
        outer = {std::min(outer.low, border.low), std::max(outer.high, border.high)};
    };
    widen(borderAt(std::min(right, p2.x)));
    for (const LatticePoint &corner : corners) {
        if (corner.x >= left && corner.x <= right)
            widen({corner.y, corner.y});
    }
    CoveredStrip strip;
    // A square that the border only touches has nothing of the triangle.
    strip.met = {std::int64_t(floorDivide<Int128>(outer.low - halfPixel, unitsPerPixel)) + 1,
                 std::int64_t(ceilDivide<Int128>(outer.high + halfPixel, unitsPerPixel))};
    strip.whole = {strip.met.end, strip.met.end};
    if (left < p0.x || right > p2.x)
        return strip;
    // The lower border is a convex function of x and the upper one a concave one: their extremes
    // within the strip are at its sides.
    const Border a = innerAt(left);
    const Border b = innerAt(right);
    const Int128 low = std::max(a.low, b.low);
    const Int128 high = std::min(a.high, b.high);
    const auto first = std::int64_t(ceilDivide<Int128>(low + halfPixel, unitsPerPixel));
    const auto last = std::int64_t(floorDivide<Int128>(high - halfPixel, unitsPerPixel));
    if (first <= last)
        strip.whole = {first, last + 1};
    return strip;
}

} // namespace pixelplumb
