// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

#include <vector>

namespace pixelplumb {

/// The choice of what becomes of lines by where their ends are.
inline constexpr const char *lineEndsChoice = "line ends";

/// Mistakes of Bresenham's line, of lines between samples: what p begins with, what is added to it,
/// where steps begin and lead, how many there are and how the colour is stepped.
std::vector<Defect> bresenhamDefects();

} // namespace pixelplumb
