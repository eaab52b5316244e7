// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

namespace pixelplumb {

/// Mistakes of a program that tests the three edges at the samples of the bounding box: in what is
/// tested, in the edge functions and in the weights of the vertices.
std::vector<Defect> edgeTestDefects();

/// The same of which samples are tested, and which of those on an edge are left out.
std::vector<Defect> boxDefects();

} // namespace pixelplumb
