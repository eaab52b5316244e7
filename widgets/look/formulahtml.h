// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explanation.h"
#include "core/scan/scansettings.h"

#include <QPalette>

namespace pixelplumb {

/// Where a formula that three channels share is written in symbols: above their rows, or, where it
/// is short and there is the width, beside them.
enum class ChannelSymbols { Above, Beside };

/// The formulas of an explanation as rich text, grouped by subject: the symbols and what came out,
/// below it the numbers put in, and in a rounding arithmetic the exact number and the error.
QString formulaHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette,
                    ChannelSymbols symbols = ChannelSymbols::Above);

/// The stages of an explanation, each with a heading; the exact numbers and the errors stand there
/// in every arithmetic, because stages are computed in double.
QString stagesHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette);

/// The formulas in plain text, a formula a line, for screen readers; the stages after them.
QString formulaText(const Explanation &explanation, Arithmetic arithmetic);

} // namespace pixelplumb
