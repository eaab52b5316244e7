// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"

#include <cstddef>

namespace pixelplumb {

class ScanTrace;
struct TracedScene;

/// A step of any method, explained by the formulas of its numbers with the trace's values put in.
Explanation explainStep(const TracedScene &traced, std::size_t stepIndex);

/// What a span is called: "Column 27, second half", "Row 3".
QString spanHeading(const ScanTrace &trace, std::size_t span);

} // namespace pixelplumb
