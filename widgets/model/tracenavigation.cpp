// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/tracenavigation.h"

#include <algorithm>
#include <limits>

namespace pixelplumb {

bool Breakpoints::pausesAt(const SpanPlace &place) const
{
    switch (place.axis) {
    case SpanAxis::Column:
        return columns.contains(place.coordinate);
    case SpanAxis::Row:
        return rows.contains(place.coordinate);
    case SpanAxis::Free:
        break;
    }
    return false;
}

namespace {

/// Whether a span may contain one of the pixels.
bool mayMeet(const std::set<std::pair<int, int>> &pixels, const SpanPlace &place)
{
    switch (place.axis) {
    case SpanAxis::Column: {
        const auto pixel
            = pixels.lower_bound({int(place.coordinate), std::numeric_limits<int>::min()});
        return pixel != pixels.end() && pixel->first == place.coordinate;
    }
    case SpanAxis::Row:
        return std::ranges::any_of(pixels, [&place](const std::pair<int, int> &pixel) {
            return pixel.second == place.coordinate;
        });
    case SpanAxis::Free:
        break;
    }
    return !pixels.empty();
}

} // namespace

bool TraceNavigation::isLanding(StepUnit unit, std::size_t position) const
{
    if (position == 0 || position == m_trace->stepCount() || unit == StepUnit::Sample)
        return true;
    const TraceStep step = m_trace->stepAt(position - 1);
    return step.kind == StepKind::SetUp || (unit == StepUnit::Span && step.kind == StepKind::Span);
}

std::size_t TraceNavigation::landingFrom(std::size_t position, StepUnit unit,
                                         StepDirection direction) const
{
    const bool forward = direction == StepDirection::Forward;
    const std::size_t last = forward ? m_trace->stepCount() : 0;
    std::size_t landing = position;
    while (landing != last) {
        landing = forward ? landing + 1 : landing - 1;
        if (isLanding(unit, landing))
            return landing;
        // Only sample steps are numerous: skip a span's all at once.
        const TraceStep step = m_trace->stepAt(landing - 1);
        if (step.kind != StepKind::Sample)
            continue;
        const std::size_t spanStep = m_trace->indexOfSpan(step.span);
        const std::size_t samples
            = m_trace->endSampleOf(step.span) - m_trace->firstSampleOf(step.span);
        landing = forward ? spanStep + samples + 1 : spanStep + 2;
    }
    return landing;
}

std::optional<QPoint> TraceNavigation::pixelOf(std::size_t stepIndex) const
{
    const TraceStep step = m_trace->stepAt(stepIndex);
    if (step.kind == StepKind::SetUp)
        return std::nullopt;
    const std::size_t sample
        = step.kind == StepKind::Sample ? step.sample : m_trace->firstSampleOf(step.span);
    if (sample < m_trace->endSampleOf(step.span)) {
        const PixelChange &change = m_trace->changes()[sample];
        return QPoint(change.x, change.y);
    }
    const SpanRecord span = m_trace->span(step.span);
    switch (span.place.axis) {
    case SpanAxis::Column:
        return QPoint(int(span.place.coordinate), int(span.firstDrawn));
    case SpanAxis::Row:
        return QPoint(int(span.firstDrawn), int(span.place.coordinate));
    case SpanAxis::Free:
        break;
    }
    return std::nullopt;
}

std::size_t TraceNavigation::spanBefore(std::size_t position) const
{
    // The number of spans entered at the position, by bisection over their steps.
    std::size_t first = 0;
    std::size_t end = m_trace->spanCount();
    while (first < end) {
        const std::size_t middle = first + (end - first) / 2;
        if (m_trace->indexOfSpan(middle) < position)
            first = middle + 1;
        else
            end = middle;
    }
    return first;
}

template <class Visit>
std::optional<std::size_t> TraceNavigation::firstInSpans(std::size_t position, std::size_t limit,
                                                         StepDirection direction,
                                                         Visit &&positionsIn) const
{
    std::optional<std::size_t> found;
    if (direction == StepDirection::Forward) {
        const auto nearest = [&](std::size_t candidate) {
            if (candidate > position && candidate <= limit && (!found || candidate < *found))
                found = candidate;
        };
        const std::size_t entered = spanBefore(position);
        for (std::size_t span = entered > 0 ? entered - 1 : 0;
             span < m_trace->spanCount() && !found && m_trace->indexOfSpan(span) < limit; ++span)
            positionsIn(span, nearest);
        return found;
    }
    const auto nearest = [&](std::size_t candidate) {
        if (candidate < position && candidate >= limit && (!found || candidate > *found))
            found = candidate;
    };
    for (std::size_t span = spanBefore(position); span > 0 && !found; --span) {
        if (m_trace->indexOfSpan(span - 1) + 1 + m_trace->endSampleOf(span - 1)
                - m_trace->firstSampleOf(span - 1)
            < limit)
            break;
        positionsIn(span - 1, nearest);
    }
    return found;
}

std::optional<std::size_t> TraceNavigation::writeOf(const QPoint &pixel, std::size_t position,
                                                    StepDirection direction) const
{
    const std::size_t limit = direction == StepDirection::Forward ? m_trace->stepCount() : 0;
    const std::set<std::pair<int, int>> wanted = {{pixel.x(), pixel.y()}};
    return firstInSpans(position, limit, direction, [&](std::size_t span, auto &&nearest) {
        if (!mayMeet(wanted, m_trace->placeOf(span)))
            return;
        const std::size_t first = m_trace->firstSampleOf(span);
        for (std::size_t index = first; index < m_trace->endSampleOf(span); ++index) {
            const PixelChange &change = m_trace->changes()[index];
            if (change.x == pixel.x() && change.y == pixel.y() && change.isWritten())
                nearest(m_trace->indexOfSpan(span) + 2 + (index - first));
        }
    });
}

std::optional<std::size_t> TraceNavigation::breakpointFrom(std::size_t position, std::size_t limit,
                                                           const Breakpoints &breakpoints,
                                                           StepDirection direction) const
{
    if (breakpoints.isEmpty())
        return std::nullopt;
    return firstInSpans(position, limit, direction, [&](std::size_t span, auto &&nearest) {
        const SpanPlace &place = m_trace->placeOf(span);
        const std::size_t step = m_trace->indexOfSpan(span);
        if (breakpoints.pausesAt(place))
            nearest(step + 1);
        if (!mayMeet(breakpoints.pixels, place))
            return;
        const std::size_t first = m_trace->firstSampleOf(span);
        for (std::size_t index = first; index < m_trace->endSampleOf(span); ++index) {
            const PixelChange &change = m_trace->changes()[index];
            if (breakpoints.pixels.contains({change.x, change.y}))
                nearest(step + 2 + (index - first));
        }
    });
}

std::size_t TraceNavigation::positionLike(const ScanTrace &other, std::size_t position) const
{
    if (position == other.stepCount())
        return m_trace->stepCount();
    if (position == 0)
        return 0;
    const TraceStep step = other.stepAt(position - 1);
    if (step.primitive >= m_trace->primitiveCount())
        return m_trace->stepCount();
    const std::size_t setUp = m_trace->indexOfSetUp(step.primitive) + 1;
    if (step.kind == StepKind::SetUp)
        return setUp;

    if (step.kind == StepKind::Sample) {
        const PixelChange &change = other.changes()[step.sample];
        if (const auto visit = m_trace->visitOf(step.primitive, change.x, change.y))
            return m_trace->indexOfSample(*visit) + 1;
    }
    const std::size_t firstSpan = m_trace->firstSpanOf(step.primitive);
    const std::size_t endSpan = m_trace->endSpanOf(step.primitive);
    if (firstSpan == endSpan)
        return setUp;
    const SpanPlace &place = other.placeOf(step.span);
    if (m_trace->placeOf(firstSpan).axis != place.axis)
        return shareOf(other, step, position);

    std::size_t span = endSpan;
    while (span > firstSpan && m_trace->placeOf(span - 1).coordinate > place.coordinate)
        --span;
    if (span == firstSpan)
        return setUp;
    --span;
    const std::size_t entered = m_trace->indexOfSpan(span) + 1;
    const std::size_t first = m_trace->firstSampleOf(span);
    std::size_t done = m_trace->endSampleOf(span) - first;
    if (m_trace->placeOf(span).coordinate != place.coordinate)
        return entered + done;
    if (step.kind == StepKind::Span)
        return entered;
    const PixelChange &reached = other.changes()[step.sample];
    const auto isBeyond = [&](const PixelChange &change) {
        return place.axis == SpanAxis::Row ? change.x > reached.x : change.y > reached.y;
    };
    while (done > 0 && isBeyond(m_trace->changes()[first + done - 1]))
        --done;
    return entered + done;
}

std::size_t TraceNavigation::shareOf(const ScanTrace &other, const TraceStep &step,
                                     std::size_t position) const
{
    const auto stepsOf = [&step](const ScanTrace &trace) {
        const std::size_t first = trace.indexOfSetUp(step.primitive);
        const std::size_t end = step.primitive + 1 < trace.primitiveCount()
            ? trace.indexOfSetUp(step.primitive + 1)
            : trace.stepCount();
        return std::pair(first, end);
    };
    const auto [otherFirst, otherEnd] = stepsOf(other);
    const auto [first, end] = stepsOf(*m_trace);
    const double share = double(position - otherFirst) / double(otherEnd - otherFirst);
    return first + std::size_t(share * double(end - first));
}

} // namespace pixelplumb
