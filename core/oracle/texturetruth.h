// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/oracle/planeweights.h"

#include <vector>

namespace pixelplumb::oracle {

/// A texel that is read, with its weight.
struct WeightedTexel {
    std::int32_t i = 0; ///< wrapped or clamped into the picture
    std::int32_t j = 0;
    WideFraction weight;
    Colour colour;
};

/// The texels that the material's filter reads at (u, v): one, or four whose weights sum to 1, in
/// the order (left, lower), (right, lower), (left, upper), (right, upper). None where the material
/// has no texture, or an incomplete one.
std::vector<WeightedTexel> texelsAt(const Material &material, const WideFraction &u,
                                    const WideFraction &v);

/// The weighted mean of one texel or more, ⌊· + ½⌋ for each channel.
Colour textureByte(const std::vector<WeightedTexel> &texels);

/// ⌊c·t/255 + ½⌋ for each channel.
Colour modulated(const Colour &colour, const Colour &by);

} // namespace pixelplumb::oracle
