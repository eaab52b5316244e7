// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/triangle.h"
#include "core/number/commonfraction.h"
#include "core/number/wideinteger.h"
#include "core/scan/scansettings.h"

/// Interpolation over a triangle in fractions of whole numbers of any size: nothing overflows,
/// nothing is rounded.
namespace pixelplumb::oracle {

using WideFraction = FractionOf<BigInteger>;

/// The weights of the three vertices at a sample, over a common denominator.
struct PlaneWeights {
    std::array<BigInteger, 3> parts; ///< below 0 where the sample lies outside
    BigInteger whole; ///< their sum

    /// Σ part·value / whole.
    WideFraction mean(const std::array<std::int64_t, 3> &values) const
    {
        return {parts[0] * values[0] + parts[1] * values[1] + parts[2] * values[2], whole};
    }
};

/// Barycentric weights: the areas opposite the vertices. `whole` is the unsigned doubled area in
/// square lattice units; 0 for a triangle without area.
PlaneWeights barycentricWeights(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// Weights along the segment of a triangle without area, by x, or by y where it lies in one column;
/// the vertex between the ends weighs nothing, and in a point the first vertex has all the weight.
PlaneWeights segmentWeights(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// Weights for perspective, the quotient of a/w and 1/w, which are linear in the frame: each
/// barycentric weight times the other two w. `whole` has the sign of 1/w at the sample: where it is
/// not above 0, the sample lies on the horizon of the triangle's plane or beyond it, and nothing is
/// visible there.
PlaneWeights perspectiveWeights(const PlaneWeights &barycentric,
                                const std::array<VertexAttributes, 3> &vertices);

/// ⌊v + ½⌋ or ⌊v⌋, clamped to 0 … 255.
std::uint8_t byteOf(const WideFraction &level, ByteRounding rounding);

} // namespace pixelplumb::oracle
