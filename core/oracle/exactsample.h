// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/oracle/effecttruth.h"
#include "core/oracle/lighttruth.h"
#include "core/oracle/texturetruth.h"

#include <optional>

namespace pixelplumb::oracle {

/// All that a triangle's plane has at a sample, from its attributes to its byte; inside and
/// outside.
struct ExactSample {
    PlaneWeights weights; ///< barycentric
    PlaneWeights attributeWeights; ///< those of perspective, where it is there; else the same
    WideFraction z; ///< linear in the frame
    std::array<WideFraction, 3> levels; ///< of the vertices' colours
    Colour interpolated; ///< their bytes
    std::array<WideFraction, 2> texture; ///< u, v
    std::vector<WeightedTexel> texels; ///< none without texture
    Colour textured; ///< modulated by them
    // Where there is light, in units of an Attribute.
    std::array<WideFraction, 3> normal; ///< not of unit length
    std::array<WideFraction, 3> place;
    std::optional<LitColour> lit; ///< none without light
    Colour colour; ///< after all of it
    WideFraction alphaLevel;
    std::uint8_t alpha = 255;
};

/// None beyond the horizon of the triangle's plane. Of a triangle without area, what its segment
/// has. `moved` is the triangle of that index, or the same at another place.
std::optional<ExactSample> exactSampleAt(const Primitives &primitives, std::size_t triangle,
                                         const Triangle &moved, ByteRounding rounding,
                                         const EffectTruth &what, std::int64_t x, std::int64_t y);

/// What a depth buffer of this format keeps: z itself, or ⌊z·(2ⁿ − 1) + ½⌋ with z clamped to 0 … 1.
WideFraction keptDepth(const WideFraction &z, DepthFormat format);

/// ⌊α·A + ½⌋, A the area of the pixel's square that is covered, 0 … 1.
std::uint8_t sharedAlpha(std::uint8_t alpha, const BigRational &area);

/// Whether a depth passes the test against one that stands: a <= b.
bool isNoFarther(const WideFraction &a, const WideFraction &b);

} // namespace pixelplumb::oracle
