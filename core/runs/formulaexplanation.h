// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"

#include <cstddef>

namespace pixelplumb {

struct TracedScene;

/// A step of any method, explained by the formulas of its numbers with the trace's values put in.
Explanation explainStep(const TracedScene &traced, std::size_t stepIndex);

} // namespace pixelplumb
