// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"

/// What a triangle is made of, and how a colour is multiplied by another: by a material's diffuse
/// one at the vertices, by a texel at the samples.
namespace pixelplumb {

/// ⌊c·d/255 + ½⌋, exactly.
constexpr std::uint8_t tinted(std::uint8_t level, std::uint8_t tint)
{
    return std::uint8_t((2 * level * tint + 255) / 510);
}
constexpr Colour tinted(const Colour &colour, const Colour &tint)
{
    return {{tinted(colour.red(), tint.red()), tinted(colour.green(), tint.green()),
             tinted(colour.blue(), tint.blue())}};
}

/// A triangle's or a solid's material, by its index; a white one where there is none of it.
const Material &materialOf(const Appearance &appearance, int material);

} // namespace pixelplumb
