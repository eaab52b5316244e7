// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/explanation.h"

#include <cstddef>

namespace pixelplumb {

struct TracedScene;

/// The way of a triangle's three corners from space to the lattice, stage by stage, with the
/// formulas of its numbers: as used, in double, next to those without rounding. Empty for a
/// triangle that the scene gives in the frame.
std::vector<StageFormulas> stageFormulas(const TracedScene &traced, std::size_t primitive);

} // namespace pixelplumb
