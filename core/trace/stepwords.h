// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

#include <optional>
#include <vector>

namespace pixelplumb {

/// The place of a step in its method's pseudocode.
enum class Moment {
    SetUp,
    Rejected, ///< the set-up found nothing to draw
    Begin, ///< the first span of a primitive or of a part of it
    Span, ///< a later span
    TakeOver, ///< a later span, where one edge takes over from another
    Stay, ///< a later span, where the decision steps along the axis only
    Cross, ///< a later span, where the decision also steps across
    Halve, ///< a piece that is halved instead of drawn
    First, ///< a span's first sample, written
    Next, ///< a later sample, written
    Refused, ///< a sample that is not written
};

/// The wording of one step: how its numbers are named, and what the kernel's family says about it.
/// Where a text is empty, the explanation common to all methods is used.
struct StepWords {
    std::vector<NumberDescription> numbers; ///< for the record's cells, in their order
    QString heading; ///< "Column 27, second half"
    QString sentence; ///< one or two sentences that a screen reader can speak
    QString event; ///< what has just changed for later steps: "L₁₂ takes over from L₀₁"
    std::optional<Moment> moment; ///< where the step's kind and place do not determine it
};

} // namespace pixelplumb
