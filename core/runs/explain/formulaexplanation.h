// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/explanation.h"
#include "core/trace/numberdescription.h"

#include <cstddef>

namespace pixelplumb {

class ScanTrace;
struct TracedScene;

/// Whether a formula continues from an earlier step.
enum class FormulaStart { Fresh, Continued };

/// Formulas start afresh in each part of a primitive, and with the first sample of a span.
FormulaStart startOfSpan(const ScanTrace &trace, std::size_t span);
inline FormulaStart startOfSample(std::size_t place)
{
    return place == 0 ? FormulaStart::Fresh : FormulaStart::Continued;
}

/// The formula by which a step computes a number, described as in that step; empty if there is
/// none.
QString formulaInForce(const NumberDescription &number, const Quantity &used, FormulaStart start);

/// A step of any method, explained by the formulas of its numbers with the trace's values put in.
Explanation explainStep(const TracedScene &traced, std::size_t stepIndex);

} // namespace pixelplumb
