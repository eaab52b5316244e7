// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

namespace pixelplumb {

/// Mistakes of a program that tests the three edges at the samples of the bounding box: in the
/// test, in the edge functions and in the vertices' weights.
std::vector<Defect> edgeTestDefectsFor(const Scene &scene);

/// Mistakes of such a program in which samples it tests, and in which of those on an edge it leaves
/// out.
std::vector<Defect> boxDefects();

/// Whether a product of differences in a triangle's box leaves 16 bits, px².
bool leavesShort(const Scene &scene);

} // namespace pixelplumb
