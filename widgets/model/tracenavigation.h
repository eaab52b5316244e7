// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QPoint>

#include <optional>
#include <set>

namespace pixelplumb {

enum class StepUnit { SetUp, Span, Sample };
enum class StepDirection { Forward, Backward };

/// Where a run pauses.
struct Breakpoints {
    std::set<std::int64_t> columns; ///< x: pauses just after the column was entered
    std::set<std::int64_t> rows; ///< y: pauses just after the row was entered
    std::set<std::pair<int, int>> pixels; ///< (x, y): pauses just after it was written or refused

    bool isEmpty() const { return columns.empty() && rows.empty() && pixels.empty(); }
    bool pausesAt(const SpanPlace &place) const;
};

/// Finds positions in a trace; moves nothing. A landing of a unit is a position at which stepping
/// by it stops: just after each set-up, each span entered, or each step; and always the start and
/// the end. Stepping by spans stops at set-ups, too: they give the slopes that the spans use.
class TraceNavigation {
public:
    explicit TraceNavigation(const ScanTrace &trace)
        : m_trace(&trace)
    {
    }

    bool isLanding(StepUnit unit, std::size_t position) const;
    /// The nearest landing beyond a position; the position itself where there is none.
    std::size_t landingFrom(std::size_t position, StepUnit unit, StepDirection direction) const;

    /// The pixel that a step writes or refuses; for a step that enters a span, the span's first
    /// pixel, or the sample nearest to it where there is none.
    std::optional<QPoint> pixelOf(std::size_t stepIndex) const;

    /// The position just after the next step that writes the pixel.
    std::optional<std::size_t> writeOf(const QPoint &pixel, std::size_t position,
                                       StepDirection direction) const;
    /// The next position at which a breakpoint pauses, beyond `position` and not beyond `limit`.
    std::optional<std::size_t> breakpointFrom(std::size_t position, std::size_t limit,
                                              const Breakpoints &breakpoints,
                                              StepDirection direction) const;

    /// The position in this trace that corresponds to another trace's: on the same span and pixel
    /// where this trace has them, else just after the nearest earlier step of the same primitive;
    /// between columns and rows, at the same share of the primitive's steps. Start maps to start,
    /// end to end.
    std::size_t positionLike(const ScanTrace &other, std::size_t position) const;

private:
    std::size_t shareOf(const ScanTrace &other, const TraceStep &step, std::size_t position) const;
    std::size_t spanBefore(std::size_t position) const;
    template <class Visit>
    std::optional<std::size_t> firstInSpans(std::size_t position, std::size_t limit,
                                            StepDirection direction, Visit &&positionsIn) const;

    const ScanTrace *m_trace;
};

} // namespace pixelplumb
