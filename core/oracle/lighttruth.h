// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/oracle/planeweights.h"

#include <vector>

/// Lighting by Blinn's formula (Blinn 1977, "Models of light reflection for computer synthesized
/// pictures"). Directions are whole numbers of any size, so that signs and zeros are decided
/// exactly; the cosines need roots, and have 50 digits.
namespace pixelplumb::oracle {

/// Of any length; only the direction matters.
using Direction = std::array<BigInteger, 3>;

/// One light's contribution at a sample.
struct LightCosines {
    double diffuse = 0; ///< max(0, N·L); nearest double
    double highlight = 0; ///< max(0, N·H)^shininess where N·L > 0, else 0; nearest double
};

struct LitColour {
    Colour colour;
    std::array<double, 3> levels = {}; ///< before rounding and clamping; nearest doubles
    /// A level is so close to the limit between two bytes that 50 digits cannot decide; the upper
    /// byte is taken.
    bool undecided = false;
    std::vector<LightCosines> lights; ///< in the appearance's order
};

/// The colour under the appearance's lights: c·(ambient + Σ light·max(0, N·L))/255 + Σ
/// light·specular/255·max(0, N·H)^shininess where N·L > 0, ⌊· + ½⌋, clamped. Terms with a direction
/// of length 0 are 0. The three components of the normal, and those of the place, have a common
/// denominator above 0; the place's are in units of an Attribute. A null material means none, with
/// a black highlight.
LitColour litColour(const Colour &colour, const std::array<WideFraction, 3> &normal,
                    const std::array<WideFraction, 3> &place, const Appearance &appearance,
                    const Material *material);

} // namespace pixelplumb::oracle
