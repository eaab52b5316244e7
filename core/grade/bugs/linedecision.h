// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/programline.h"

#include <vector>

namespace pixelplumb {

/// A mistake of lines, whether steps begin at a line's first end or at its left one.
struct LineRow {
    const char *id;
    const char *forStudent;
    const char *forAssistant; ///< without its full stop
    ProgramLine program;
};

const std::vector<LineRow> &decisionBeginnings(); ///< what p begins with
const std::vector<LineRow>
    &decisionSteps(); ///< what is added to it, when, and where it steps across

} // namespace pixelplumb
