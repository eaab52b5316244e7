// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/explanation.h"
#include "core/trace/scantrace.h"

/// The assignment's formulas (seed 004) with the trace's numbers put in, by kind of step.
namespace pixelplumb {

struct TracedScene;

Explanation explainSetUp(const TracedScene &traced, std::size_t index);
Explanation explainColumn(const TracedScene &traced, const TraceStep &step);
Explanation explainPixel(const TracedScene &traced, const TraceStep &step);

} // namespace pixelplumb
