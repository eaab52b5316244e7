// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

namespace pixelplumb {

/// A 1 for each pixel in which `found` differs from what was `drawn` of the scene and at which a
/// right program may have it so: it has what stood there before a triangle on whose edge its sample
/// lies, where rules differ, or nearer to an edge than a right program errs that computes in this
/// arithmetic; or the colour of such a triangle, or of one that covers it, no farther from the
/// exact one than such a program's (TriangleLeeway; resources/numerics.md, 3.9). A third colour is
/// none of these. Of lines by Bresenham's steps it has what a program draws that goes the other way
/// at p = 0, or steps from a line's other end. With effects beyond colour, and with other shapes,
/// those of samples on an edge that have what the scene has under another rule. Line by line, the
/// top line first.
std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &drawn,
                                            const Picture &found, Arithmetic arithmetic);

} // namespace pixelplumb
