// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"

/// A triangle's material, and the multiplication of two colours: by the material's diffuse colour
/// at the vertices, by a texel at the samples.
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

/// The material of a triangle or solid by its index; a white one where the index names none.
const Material &materialOf(const Appearance &appearance, int material);

} // namespace pixelplumb
