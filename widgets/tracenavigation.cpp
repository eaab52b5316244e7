// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/tracenavigation.h"

#include <limits>

namespace pixelplumb {

bool Breakpoints::mayPauseAt(std::int64_t x) const
{
    if (columns.contains(x))
        return true;
    const auto pixel = pixels.lower_bound({int(x), std::numeric_limits<int>::min()});
    return pixel != pixels.end() && pixel->first == x;
}

bool TraceNavigation::isLanding(StepUnit unit, std::size_t position) const
{
    if (position == 0 || position == m_trace->stepCount() || unit == StepUnit::Pixel)
        return true;
    const TraceStep step = m_trace->stepAt(position - 1);
    if (unit == StepUnit::SetUp)
        return step.kind == StepKind::SetUp;
    if (step.kind == StepKind::SetUp)
        return m_trace->firstColumnOf(step.triangle) == m_trace->endColumnOf(step.triangle);
    return step.kind == StepKind::Column;
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
        // Only pixel steps are many: pass a column's in one go.
        const TraceStep step = m_trace->stepAt(landing - 1);
        if (step.kind != StepKind::Pixel)
            continue;
        const std::size_t columnStep = m_trace->indexOfColumn(step.column);
        const std::size_t pixels
            = m_trace->endPixelOf(step.column) - m_trace->firstPixelOf(step.column);
        landing = forward ? columnStep + pixels + 1 : columnStep + 2;
    }
    return landing;
}

std::optional<QPoint> TraceNavigation::pixelOf(std::size_t stepIndex) const
{
    const TraceStep step = m_trace->stepAt(stepIndex);
    if (step.kind == StepKind::SetUp)
        return std::nullopt;
    const std::size_t pixel
        = step.kind == StepKind::Pixel ? step.pixel : m_trace->firstPixelOf(step.column);
    if (pixel < m_trace->endPixelOf(step.column)) {
        const PixelChange &change = m_trace->changes()[pixel];
        return QPoint(change.x, change.y);
    }
    const ColumnRecord column = m_trace->column(step.column);
    return QPoint(int(column.x), int(column.firstDrawnRow));
}

std::size_t TraceNavigation::columnBefore(std::size_t position) const
{
    // The number of columns entered at the position, by bisection on their steps.
    std::size_t first = 0;
    std::size_t end = m_trace->columnCount();
    while (first < end) {
        const std::size_t middle = first + (end - first) / 2;
        if (m_trace->indexOfColumn(middle) < position)
            first = middle + 1;
        else
            end = middle;
    }
    return first;
}

template <class Visit>
std::optional<std::size_t> TraceNavigation::firstInColumns(std::size_t position, std::size_t limit,
                                                           StepDirection direction,
                                                           Visit &&positionsIn) const
{
    std::optional<std::size_t> found;
    if (direction == StepDirection::Forward) {
        const auto nearest = [&](std::size_t candidate) {
            if (candidate > position && candidate <= limit && (!found || candidate < *found))
                found = candidate;
        };
        const std::size_t entered = columnBefore(position);
        for (std::size_t column = entered > 0 ? entered - 1 : 0;
             column < m_trace->columnCount() && !found && m_trace->indexOfColumn(column) < limit;
             ++column)
            positionsIn(column, nearest);
        return found;
    }
    const auto nearest = [&](std::size_t candidate) {
        if (candidate < position && candidate >= limit && (!found || candidate > *found))
            found = candidate;
    };
    for (std::size_t column = columnBefore(position); column > 0 && !found; --column) {
        if (m_trace->indexOfColumn(column - 1) + 1 + m_trace->endPixelOf(column - 1)
                - m_trace->firstPixelOf(column - 1)
            < limit)
            break;
        positionsIn(column - 1, nearest);
    }
    return found;
}

std::optional<std::size_t> TraceNavigation::writeOf(const QPoint &pixel, std::size_t position,
                                                    StepDirection direction) const
{
    const std::size_t limit = direction == StepDirection::Forward ? m_trace->stepCount() : 0;
    return firstInColumns(position, limit, direction, [&](std::size_t column, auto &&nearest) {
        const std::size_t first = m_trace->firstPixelOf(column);
        const std::size_t end = m_trace->endPixelOf(column);
        if (first == end || m_trace->changes()[first].x != pixel.x())
            return;
        for (std::size_t index = first; index < end; ++index) {
            if (m_trace->changes()[index].y == pixel.y())
                nearest(m_trace->indexOfColumn(column) + 2 + (index - first));
        }
    });
}

std::optional<std::size_t> TraceNavigation::breakpointFrom(std::size_t position, std::size_t limit,
                                                           const Breakpoints &breakpoints,
                                                           StepDirection direction) const
{
    if (breakpoints.isEmpty())
        return std::nullopt;
    return firstInColumns(position, limit, direction, [&](std::size_t column, auto &&nearest) {
        const std::int64_t x = m_trace->xOf(column);
        if (!breakpoints.mayPauseAt(x))
            return;
        const std::size_t step = m_trace->indexOfColumn(column);
        if (breakpoints.columns.contains(x))
            nearest(step + 1);
        const std::size_t first = m_trace->firstPixelOf(column);
        for (std::size_t index = first; index < m_trace->endPixelOf(column); ++index) {
            if (breakpoints.pixels.contains({int(x), m_trace->changes()[index].y}))
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
    if (step.triangle >= m_trace->triangleCount())
        return m_trace->stepCount();
    const std::size_t setUp = m_trace->indexOfSetUp(step.triangle) + 1;
    if (step.kind == StepKind::SetUp)
        return setUp;

    const std::int64_t x = other.xOf(step.column);
    std::size_t column = m_trace->endColumnOf(step.triangle);
    const std::size_t firstColumn = m_trace->firstColumnOf(step.triangle);
    while (column > firstColumn && m_trace->xOf(column - 1) > x)
        --column;
    if (column == firstColumn)
        return setUp;
    --column;
    const std::size_t entered = m_trace->indexOfColumn(column) + 1;
    const std::size_t first = m_trace->firstPixelOf(column);
    std::size_t done = m_trace->endPixelOf(column) - first;
    if (m_trace->xOf(column) != x)
        return entered + done;
    if (step.kind == StepKind::Column)
        return entered;
    const std::int32_t y = other.changes()[step.pixel].y;
    while (done > 0 && m_trace->changes()[first + done - 1].y > y)
        --done;
    return entered + done;
}

} // namespace pixelplumb
