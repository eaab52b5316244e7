// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"
#include "core/scan/scanbugs.h"

namespace pixelplumb {

/// Walks the triangle by a program with these bugs, in the scene's arithmetic, or on the triangle's
/// side of rounding in float64. False, with nothing changed, where the mistaken scan cannot
/// (mistakenscan.h).
bool walkAs(TriangleRuns &triangle, const ScanBugs &bugs);

/// The walk as a redrawing, which can be combined with others.
Redrawing redrawingBy(const ScanBugs &bugs);

} // namespace pixelplumb
