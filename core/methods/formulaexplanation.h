// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/explanation.h"

#include <cstddef>

namespace pixelplumb {

struct TracedScene;

/// A step of any method, explained by the formulas of its trace columns with the trace's numbers
/// put in.
Explanation explainByFormulas(const TracedScene &traced, std::size_t stepIndex);

/// The step's explanation: the method's own, or by its formulas.
Explanation explainStep(const TracedScene &traced, std::size_t stepIndex);

} // namespace pixelplumb
