// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

#include <array>
#include <vector>

/// A stroke: the area covered by a line or curve drawn one pixel wide. A line is the rectangle one
/// pixel wide around its segment, with butt ends: it ends where the segment ends. A circle, ellipse
/// or Bézier curve is a strip of quadrilaterals around points of the curve; neighbours share the
/// joint edge between them, ½ px to either side of the curve.
///
/// Exact are the points on the lattice, which are not snapped, and all areas of the polygons.
/// Rounded to the nearest 2^-16 px are the half widths, because a unit vector is irrational in most
/// directions, and the points of curves. A line's four corners use the same half width, so its
/// rectangle is a parallelogram whose border is displaced by less than 2^-16.5 px, and whose area
/// is the line's length to one part in 2^15.5. Curves are subdivided until the chords between their
/// points are within 2^-10 px of them.
namespace pixelplumb {

/// A coordinate of strokes in units of 2^-16 px: 1/256 lattice unit.
using StrokeUnit = std::int64_t;
inline constexpr StrokeUnit strokeUnitsPerPixel = 1 << 16;
inline constexpr StrokeUnit strokeHalfPixel = strokeUnitsPerPixel / 2;
inline constexpr StrokeUnit strokeUnitsPerLattice = strokeUnitsPerPixel / unitsPerPixel;

struct StrokePoint {
    StrokeUnit x = 0;
    StrokeUnit y = 0;

    friend constexpr bool operator==(const StrokePoint &, const StrokePoint &) = default;
};

/// A point of the line or curve, and its half width: ½ px to the left of the direction of travel, y
/// upward. Without a direction there is no width.
struct StrokeJoint {
    StrokePoint at;
    StrokePoint half;

    StrokePoint left() const { return {at.x + half.x, at.y + half.y}; }
    StrokePoint right() const { return {at.x - half.x, at.y - half.y}; }
};

/// The part between two joints: counterclockwise, except where the curve turns tighter than ½ px
/// and the strip folds.
using StrokeQuad = std::array<StrokePoint, 4>;

struct StrokeStrip {
    std::int64_t pieces = 0; ///< quadrilaterals of the whole stroke; 0 if it has no length
    /// The quadrilaterals that may meet a pixel of the frame, in the order of the curve.
    std::vector<StrokeQuad> quads;
};

/// Whether the shape is a line or a curve that a stroke can draw: lines, outlined circles and
/// ellipses, Bézier curves.
bool isStroke(const Shape &shape);

/// The stroke of such a shape (sample coordinates).
StrokeStrip strokeStripOf(const Shape &shape, const FrameView &frame);

/// ½ px to the left of a direction, each part up to 2^110: (−dy, dx)/(2·√(dx² + dy²)), each
/// coordinate rounded to the nearest unit, halves away from 0; (0, 0) without a direction.
StrokePoint strokeHalfWidth(Int128 dx, Int128 dy);

/// Whether a line or curve is shorter than a pixel: even one pixel wide, it may lie between all
/// samples.
bool isShort(const Shape &stroke);

} // namespace pixelplumb
