// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"

#include <vector>

namespace pixelplumb {

/// The choice of how lines are treated according to where their ends are.
inline constexpr const char *lineEndsChoice = "line ends";

/// Mistakes in Bresenham's lines between samples: what p begins with, what is added to it, where
/// steps begin and lead, how many there are and how the colour is stepped.
std::vector<Defect> bresenhamDefects();

} // namespace pixelplumb
