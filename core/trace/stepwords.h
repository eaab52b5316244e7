// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

#include <vector>

namespace pixelplumb {

/// How one step is spoken of: what its numbers are called in it, and what the kernel's family says
/// of it. Empty texts are left to the explanation that serves every method.
struct StepWords {
    std::vector<NumberDescription> numbers; ///< of the record's cells, in their order
    QString heading; ///< "Column 27, second half"
    QString sentence; ///< one or two sentences that a screen reader can speak
    QString event; ///< what has just changed for the steps to come: "L₁₂ takes over from L₀₁"
};

} // namespace pixelplumb
