// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// A 1 for each pixel in which `found` differs from `drawn`, the scene's picture by its outlines,
/// filled, and which it has where an edge's steps take the other pixel at p = 0, or levels differ
/// by the rounding of this arithmetic.
std::vector<std::uint8_t> ofOtherOutlines(const Scene &scene, const Picture &drawn,
                                          const Picture &found, Arithmetic arithmetic);

} // namespace pixelplumb
