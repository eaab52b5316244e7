// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

namespace pixelplumb {

/// A 1 for each pixel at which a right program may have what `found` has, whatever the truth says:
/// its sample lies on an edge, where rules differ, or nearer to one than a right program errs that
/// computes in this arithmetic; or the byte of its colour is that of a level no farther from the
/// exact one than such a program's (resources/numerics.md, 3.9), or it is one of a triangle without
/// area. Exact: ties alone. Line by line,
/// the top line first. With effects beyond colour, and of triangles beyond 2^16 px, ties alone.
std::vector<std::uint8_t> undecidablePixels(const Scene &scene, const Picture &found,
                                            Arithmetic arithmetic);

} // namespace pixelplumb
