// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/explanation.h"
#include "core/scan/scansettings.h"

#include <QPalette>

namespace pixelplumb {

/// Where the symbols of a formula that three channels share are written: above their rows, or,
/// where they are short and there is room, beside them.
enum class ChannelSymbols { Above, Beside };

/// The formulas of an explanation as rich text, grouped by subject: the symbols and the result,
/// below them the numbers put in, and in a rounding arithmetic the exact number and the error.
QString formulaHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette,
                    ChannelSymbols symbols = ChannelSymbols::Above);

/// The stages of an explanation, each with a heading. They show exact numbers and errors in every
/// arithmetic, because stages are computed in double.
QString stagesHtml(const Explanation &explanation, Arithmetic arithmetic, const QPalette &palette);

/// The formulas as plain text for screen readers, one per line, followed by the stages.
QString formulaText(const Explanation &explanation, Arithmetic arithmetic);

} // namespace pixelplumb
