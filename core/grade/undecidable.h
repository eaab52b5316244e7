// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

namespace pixelplumb {

/// A 1 for each pixel in which `found` differs from `drawn`, the scene's picture, and which a right
/// program may have as found. With triangles that is what stood there before a triangle on whose
/// edge the sample lies, where rules differ, or to whose edge it is closer than a right program
/// errs in this arithmetic; or the colour of such a triangle, or of one that covers the sample, no
/// farther from the exact colour than such a program's (TriangleLeeway; resources/numerics.md,
/// 3.9). A third colour does not count. With lines it is a pixel that is as near as the method's up
/// to rounding (LineChoice), with filled outlines what ties of their lines change. With effects
/// beyond colour, and with other shapes, it is what the scene has under another rule at samples on
/// an edge. Line by line, the top line first.
std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, Arithmetic arithmetic);

} // namespace pixelplumb
