// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

#include <vector>

namespace pixelplumb {

/// Mistakes in Bresenham's decision, of lines between samples: what p begins with, what is added to
/// it and where it steps across. Each from a line's first end, and from its left one.
std::vector<Defect> lineDecisionDefects();

} // namespace pixelplumb
