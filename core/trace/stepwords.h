// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// What a step is in the pseudocode of its method.
enum class Moment {
    SetUp,
    Rejected, ///< the set-up found that nothing is to be drawn
    Begin, ///< the first span of a primitive or of a part of it
    Span, ///< a further one
    Stay, ///< a further one, by a decision that leads along
    Cross, ///< by one that leads across, too
    Halve, ///< a piece that is not drawn but divided
    First, ///< a span's first sample, written
    Next, ///< a further one, written
    Refused, ///< a sample that is not written
};

/// How one step is spoken of: what its numbers are called in it, and what the kernel's family says
/// of it. Empty texts are left to the explanation that serves every method.
struct StepWords {
    std::vector<NumberDescription> numbers; ///< of the record's cells, in their order
    QString heading; ///< "Column 27, second half"
    QString sentence; ///< one or two sentences that a screen reader can speak
    QString event; ///< what has just changed for the steps to come: "L₁₂ takes over from L₀₁"
    std::optional<Moment> moment; ///< where the kind of the step and its place do not say it
};

} // namespace pixelplumb
