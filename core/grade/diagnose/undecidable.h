// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/grade/rounding/margin.h"

namespace pixelplumb {

/// The scene whose picture is right by the margin: this one, but where each shared sample is to be
/// drawn once and the scene's own fill rule is seen to draw it twice, or not at all, that under a
/// watertight rule.
Scene judgedScene(const Scene &scene, const Margin &margin);

/// A 1 for each pixel in which `found` differs from `drawn`, the scene's picture, and which a right
/// program may have as found, by the margin; the scene is a judgedScene(). With triangles that is
/// what stood there before a triangle where it is open whether that draws the sample; or the colour
/// of such a triangle, or of one that covers the sample, no farther from the exact colour than such
/// a program's (TriangleMargin; resources/numerics.md, 3.9); a third colour does not count, nor
/// does a hole between triangles (holesAmong). With lines it is a pixel that is as near as the
/// method's up to rounding (LineChoice), with filled outlines what ties of their lines change. With
/// effects it is what any triangles make of it that may be drawn there (ofOtherTriangles). Line by
/// line, the top line first.
std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, const Margin &margin = {});

} // namespace pixelplumb
