// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/oracle/effecttruth.h"
#include "core/oracle/lighttruth.h"
#include "core/scan/scansettings.h"

#include <optional>
#include <vector>

namespace pixelplumb::oracle {

/// A texel read at a sample.
struct TexelTruth {
    std::int32_t i = 0; ///< wrapped or clamped into the picture
    std::int32_t j = 0;
    Quantity weight; ///< 0 … 1
    Colour colour;
};

/// The true numbers of a triangle at a sample, for comparison with a kernel's. Rational where
/// numerator and denominator fit 128 bits, else the nearest double.
struct EffectSample {
    Quantity area; ///< of the pixel's square that the triangle covers, 0 … 1
    std::array<Quantity, 3> weights; ///< barycentric, of the three vertices; sum 1
    Quantity z;
    Quantity depth; ///< z as the depth buffer stores it
    Quantity reciprocalW; ///< 1/w
    std::array<Quantity, 3> levels; ///< interpolated from the vertices' colours
    Colour interpolated; ///< the bytes of the levels
    std::array<Quantity, 2> texture; ///< u, v
    std::array<Quantity, 2> affineTexture; ///< as if all w were equal
    std::vector<TexelTruth> texels; ///< one, or four in the order of texelsAt; none without texture
    Colour textured; ///< modulated by the texels
    // Only with light.
    std::array<Quantity, 3> normal; ///< not of unit length
    std::array<Quantity, 3> place;
    std::optional<LitColour> lit; ///< none without light
    Colour colour; ///< after texture and light
    Quantity alphaLevel;
    std::uint8_t alpha = 255; ///< its byte
    std::uint8_t sharedAlpha = 255; ///< alpha times the area with area antialiasing, else alpha
};

/// Valid inside and outside the triangle. None beyond the horizon of its plane (hasPerspective).
std::optional<EffectSample> effectSampleAt(const Primitives &primitives, std::size_t triangle,
                                           ByteRounding rounding, const EffectTruth &what,
                                           std::int64_t x, std::int64_t y);

} // namespace pixelplumb::oracle
