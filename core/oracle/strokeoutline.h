// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"
#include "core/number/wideinteger.h"

#include <vector>

/// The outline of a stroke (defined in core/shade/strokes/strokestrip.h), in numbers of any size:
/// half widths by bisection, circles as fractions, Bézier points by de Casteljau's algorithm.
namespace pixelplumb::oracle {

/// A pixel in outline units of 2^-16 px, half of its side, and the lattice unit.
inline constexpr std::int64_t outlinePixel = 1 << 16;
inline constexpr std::int64_t halfSquare = outlinePixel / 2;
inline constexpr std::int64_t outlineLattice = outlinePixel / unitsPerPixel;

/// In outline units.
struct OutlinePoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    friend bool operator==(const OutlinePoint &, const OutlinePoint &) = default;
};

/// Counterclockwise, y upward: the stroke lies to its left.
struct OutlineEdge {
    OutlinePoint from;
    OutlinePoint to;
};

/// The edges of the strip's two sides and two ends. Where the curve is far from the frame, to one
/// side of it, fewer edges take the same way: no pixel of the frame shows the difference.
std::vector<OutlineEdge> strokeOutline(const Shape &stroke, const FrameView &frame);

/// How much of the square around a point the stroke covers, in squares: the sum over everything its
/// outline winds around, which may be below 0 or above 1 where the outline crosses itself. By
/// Green's theorem: −∮ y dx, with y clamped between the square's lower and upper side.
BigRational strokeArea(const std::vector<OutlineEdge> &edges, const OutlinePoint &centre);

/// How often the outline winds around a point, which counts as displaced to the right and, by less,
/// up.
int strokeWinding(const std::vector<OutlineEdge> &edges, const OutlinePoint &point);

} // namespace pixelplumb::oracle
