// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"

/// The colours of test pictures.
namespace pixelplumb {

inline constexpr Colour red = {{255, 0, 0}};
inline constexpr Colour green = {{0, 255, 0}};
inline constexpr Colour blue = {{0, 0, 255}};

} // namespace pixelplumb
