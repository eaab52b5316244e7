// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/agreement.h"
#include "core/frame/writtenframe.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// Which end of a span decided a sample.
enum class DecidingBound : std::uint8_t { None, Lower, Upper };

/// Why one run differs from the truth at one pixel, with the numbers that show it.
struct Deviation {
    Disagreement reason = Disagreement::None;
    Difference kind = Difference::None;
    std::optional<std::size_t> primitive; ///< the one whose pixel is missing, extra or off
    std::optional<std::size_t> span; ///< of the run, where it has a span there
    DecidingBound bound = DecidingBound::None;
    Quantity used, exact; ///< the bound, px; none where no bound decides
    bool isTie = false; ///< the sample lies exactly on an edge of the primitive
};

/// A finished run with its own truth: the facts from which deviations are derived.
struct JudgedRun {
    const Primitives *primitives = nullptr; ///< all of the scene, in sample coordinates
    const TracedScene *traced = nullptr;
    const WrittenFrame *drawn = nullptr;
    const WrittenFrame *truth = nullptr; ///< under the run's own fill rule
    /// The same method's picture in exact arithmetic; null if the method has none, or if the run is
    /// exact already.
    const WrittenFrame *inExactArithmetic = nullptr;
};

/// How a pixel of the run differs from the run's truth.
Difference differenceAt(const JudgedRun &run, std::int64_t x, std::int64_t y);

/// The reason and the numbers behind it; Disagreement::None where the run is right.
Deviation deviationAt(const JudgedRun &run, std::int64_t x, std::int64_t y);

/// A sentence or two with the numbers put in; empty where the run is right.
QString textOf(const Deviation &deviation, const JudgedRun &run, std::int64_t x, std::int64_t y);

/// True when each step computes the number from the step before: its formula names itself.
bool isIncremental(const NumberDescription &number);
/// True if the method computes, by increments, any span or sample number that rounding can change.
bool isIncremental(const Method &method);

/// The exact number rounded to the arithmetic's precision.
Quantity roundedTo(Arithmetic arithmetic, const Quantity &exact);

} // namespace pixelplumb
