// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"
#include "core/grade/rounding/margin.h"

namespace pixelplumb {

/// A 1 for each pixel in which `found` differs from `drawn`, the picture of a scene with effects,
/// and which it has where a right program draws other triangles of those that are open there
/// (SampleChoice): each set of them makes a colour. With blending alone a colour may also be off by
/// the rounding of its levels. With antialiasing, where each pixel has several samples, it is what
/// another fill rule makes of the whole pixel.
std::vector<std::uint8_t> ofOtherTriangles(const Scene &scene, const Picture &drawn,
                                           const Picture &found, const Margin &margin);

} // namespace pixelplumb
