// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace pixelplumb {

/// Why a primitive draws nothing.
enum class PrimitiveRejection {
    ZeroArea, ///< no colour plane, and only the closed rule paints a segment or a point
    OutsideFrame, ///< no sample of the frame lies in its bounding box, or in the primitive itself
    BetweenSamples, ///< it reaches into the frame but covers no sample; reported for a run, never
                    ///< by a kernel
    NotRepresentable, ///< the arithmetic holds no coordinate from 2^15 px: fixed16.16, and
                      ///< exact products with variants
    OutlineTooLarge, ///< a text's outline reaches 2^30 px
    VerticalLine, ///< y = m·x + b has no m
    LineOfNoLength, ///< nor does a point
    StrokeOfNoLength, ///< a stroke along a point has no area
    NotOfThisMethod, ///< the method draws other kinds of primitives
    NotConvex, ///< a polygon that no fan of triangles tiles
    SelfCrossing, ///< edges of a polygon cross between vertices
    NoOutline, ///< a text with no visible character
    FontMissing, ///< no outlines for a text: the font is missing
};

/// The reason, and where in the primitive it shows.
struct Rejection {
    // NOLINTNEXTLINE(google-explicit-constructor): most reasons are seen nowhere in particular.
    Rejection(PrimitiveRejection why)
        : reason(why)
    {
    }
    Rejection(PrimitiveRejection why, std::vector<std::size_t> where)
        : reason(why)
        , vertices(std::move(where))
    {
    }

    PrimitiveRejection reason;
    /// The vertex at which a polygon is not convex, or the ends of the two edges that cross.
    /// Counted from 0, as in the scene's file; empty where no place is known.
    std::vector<std::size_t> vertices;

    friend bool operator==(const Rejection &, const Rejection &) = default;
    friend bool operator==(const Rejection &rejection, PrimitiveRejection other)
    {
        return rejection.reason == other;
    }
};

} // namespace pixelplumb
