// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/trace/numberdescription.h"

#include <QString>

#include <vector>

namespace pixelplumb {

/// One formula of the current step: in symbols, with the numbers filled in, and its result.
struct FormulaLine {
    NumberSubject subject = NumberSubject::General;
    QString symbols; ///< "y_B ← y_B + m₀₁"
    QString substituted; ///< "12 5/8 + 3/8"
    Quantity used; ///< what the kernel computed
    Quantity exact; ///< what it would be without rounding; none where there is nothing to compare
};

/// One stage of a vertex's way from space to the frame, or of a polygon corner that clipping makes.
/// A given number stands alone in its symbols.
struct StageFormulas {
    QString stage; ///< "Clip coordinates"
    QString point; ///< "V₀", "C₁"
    QString note; ///< "V₁, kept"
    std::vector<FormulaLine> lines;
};

/// What the current step does, in words and in numbers; all numbers are those of the trace.
struct Explanation {
    QString heading; ///< "Column 27, second half"
    QString sentence; ///< one sentence that a screen reader can speak
    QString event; ///< what has just changed for the steps to come: "L₁₂ takes over from L₀₁"
    std::vector<FormulaLine> lines;
    /// For a triangle that a camera made of a solid, when it begins: its way to the frame.
    std::vector<StageFormulas> stages = {};
};

} // namespace pixelplumb
