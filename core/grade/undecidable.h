// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/margin.h"
#include "core/grade/picture.h"

namespace pixelplumb {

/// A 1 for each pixel in which `found` differs from `drawn`, the scene's picture, and which a right
/// program may have as found, by the margin. With triangles that is what stood there before a
/// triangle where it is open whether that draws the sample; or the colour of such a triangle, or of
/// one that covers the sample, no farther from the exact colour than such a program's
/// (TriangleMargin; resources/numerics.md, 3.9); a third colour does not count, nor does a hole
/// between two triangles (sharedSamples). With lines it is a pixel that is as near as the method's
/// up to rounding (LineChoice), with filled outlines what ties of their lines change. With effects
/// beyond colour, and with other shapes, it is what the scene has under another rule at samples on
/// an edge, where these are open. Line by line, the top line first.
std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, const Margin &margin = {});

} // namespace pixelplumb
