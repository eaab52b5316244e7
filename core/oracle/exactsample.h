// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/oracle/effecttruth.h"
#include "core/oracle/lighttruth.h"
#include "core/oracle/texturetruth.h"

#include <optional>

namespace pixelplumb::oracle {

/// Everything a triangle's plane has at a sample, from attributes to byte; inside and outside.
struct ExactSample {
    PlaneWeights weights; ///< barycentric
    PlaneWeights attributeWeights; ///< perspective weights where there is perspective, else the
                                   ///< same as `weights`
    WideFraction z; ///< linear in the frame
    std::array<WideFraction, 3> levels; ///< interpolated from the vertices' colours
    Colour interpolated; ///< the bytes of the levels
    std::array<WideFraction, 2> texture; ///< u, v
    std::vector<WeightedTexel> texels; ///< none without texture
    Colour textured; ///< modulated by the texels
    // Only with light, in units of an Attribute.
    std::array<WideFraction, 3> normal; ///< not of unit length
    std::array<WideFraction, 3> place;
    std::optional<LitColour> lit; ///< none without light
    Colour colour; ///< after texture and light
    WideFraction alphaLevel;
    std::uint8_t alpha = 255;
};

/// None beyond the horizon of the triangle's plane. A triangle without area has the values of its
/// segment. `moved` is that triangle, possibly displaced.
std::optional<ExactSample> exactSampleAt(const Primitives &primitives, std::size_t triangle,
                                         const Triangle &moved, ByteRounding rounding,
                                         const EffectTruth &what, std::int64_t x, std::int64_t y);

/// A depth as a buffer of this format stores it: z itself, or ⌊z·(2ⁿ − 1) + ½⌋ with z clamped to 0
/// … 1.
WideFraction keptDepth(const WideFraction &z, DepthFormat format);

/// ⌊α·A + ½⌋, with A the covered area of the pixel's square, 0 … 1.
std::uint8_t sharedAlpha(std::uint8_t alpha, const BigRational &area);

/// Whether depth a passes the depth test against the stored depth b: a <= b.
bool isNoFarther(const WideFraction &a, const WideFraction &b);

/// R, G and B interpolated from the vertices' colours, before texture, light and blending; the
/// first vertex's where the truth is not smooth.
std::array<Quantity, 3> colourLevelsAt(const Primitives &primitives, std::size_t triangle,
                                       const EffectTruth &what, std::int64_t x, std::int64_t y);

} // namespace pixelplumb::oracle
