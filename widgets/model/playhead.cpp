// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

Playhead::Playhead(QObject *parent)
    : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Playhead::playDueSteps);
}

Playhead::~Playhead() = default;

void Playhead::setTraced(std::shared_ptr<const TracedScene> traced)
{
    const std::shared_ptr<const TracedScene> previous = std::exchange(m_traced, std::move(traced));
    const std::size_t oldPosition = m_cursor ? m_cursor->position() : 0;
    const bool pickFollowedStep = previous && oldPosition > 0
        && m_picked == TraceNavigation(*previous->trace).pixelOf(oldPosition - 1);
    m_cursor.reset();
    m_setOutFrom.reset();
    if (!m_traced) {
        m_picked.reset();
        setPlaying(false);
        emit tracedChanged();
        tellAhead();
        emit positionChanged(0);
        emit pickedPixelChanged();
        return;
    }
    m_cursor = std::make_unique<TraceCursor>(*m_traced->trace, m_traced->scene.frame);
    std::size_t position = 0;
    bool isPickOfStep = pickFollowedStep;
    if (previous) {
        const std::size_t before = previous->primitives.size();
        const bool isShownAgain = m_traced->scene.hiddenCount() < previous->scene.hiddenCount();
        const bool isNew = m_traced->primitives.size() > before && (!isShownAgain || before == 0);
        isPickOfStep = isPickOfStep || isNew; // the panels explain exactly the step shown
        position = !isNew  ? navigation().positionLike(*previous->trace, oldPosition)
            : m_isForetold ? m_traced->trace->indexOfSetUp(before)
                           : m_traced->trace->stepCount();
    }
    m_cursor->seek(position);
    std::optional<QPoint> stepsPixel;
    if (isPickOfStep && position > 0)
        stepsPixel = navigation().pixelOf(position - 1);
    const bool pickMoved = setPicked(stepsPixel ? stepsPixel : m_picked);
    emit tracedChanged();
    tellAhead();
    emit positionChanged(position);
    if (pickMoved)
        emit pickedPixelChanged();
}

std::size_t Playhead::position() const { return m_cursor ? m_cursor->position() : 0; }

std::size_t Playhead::end() const { return m_traced ? m_traced->trace->stepCount() : 0; }

const FrameBuffer *Playhead::frame() const { return m_cursor ? &m_cursor->frame() : nullptr; }

std::optional<TraceStep> Playhead::currentStep() const
{
    if (position() == 0)
        return std::nullopt;
    return m_traced->trace->stepAt(position() - 1);
}

std::optional<std::size_t> Playhead::currentSpan() const
{
    const std::optional<TraceStep> step = currentStep();
    if (!step || step->kind == StepKind::SetUp)
        return std::nullopt;
    return step->span;
}

std::optional<SpanPlace> Playhead::currentPlace() const
{
    const std::optional<std::size_t> span = currentSpan();
    return span ? std::optional(m_traced->trace->placeOf(*span)) : std::nullopt;
}

std::optional<std::int64_t> Playhead::currentColumnX() const
{
    const std::optional<SpanPlace> place = currentPlace();
    if (!place || place->axis != SpanAxis::Column)
        return std::nullopt;
    return place->coordinate;
}

SpanAxis Playhead::axis() const
{
    if (const std::optional<SpanPlace> place = currentPlace())
        return place->axis;
    const bool hasSpans = m_traced && m_traced->trace->spanCount() > 0;
    if (hasSpans)
        return m_traced->trace->placeOf(0).axis;
    return m_traced ? m_traced->method->spanAxis : SpanAxis::Column;
}

std::optional<QPoint> Playhead::currentPixel() const
{
    const std::optional<TraceStep> step = currentStep();
    if (!step || step->kind != StepKind::Sample)
        return std::nullopt;
    return navigation().pixelOf(position() - 1);
}

void Playhead::seek(std::size_t position)
{
    m_setOutFrom.reset();
    moveTo(position);
}

void Playhead::seekToSpan(std::size_t span)
{
    if (m_traced && span < m_traced->trace->spanCount())
        seek(m_traced->trace->indexOfSpan(span) + 1);
}

void Playhead::seekToPixelStep(std::size_t stepIndex)
{
    if (m_traced && stepIndex < end())
        seek(stepIndex + 1);
}

void Playhead::setUnit(StepUnit unit)
{
    if (m_unit == unit)
        return;
    m_unit = unit;
    emit unitChanged(unit);
}

void Playhead::step(StepUnit unit, StepDirection direction)
{
    if (!m_traced)
        return;
    if (!navigation().isLanding(unit, position()))
        m_setOutFrom = position();
    moveTo(stopFrom(position(), unit, direction));
}

std::size_t Playhead::stopFrom(std::size_t position, StepUnit unit, StepDirection direction) const
{
    const std::size_t landing = navigation().landingFrom(position, unit, direction);
    if (!m_setOutFrom)
        return landing;
    if (direction == StepDirection::Forward)
        return *m_setOutFrom > position ? std::min(landing, *m_setOutFrom) : landing;
    return *m_setOutFrom < position ? std::max(landing, *m_setOutFrom) : landing;
}

void Playhead::run(StepDirection direction)
{
    if (!m_traced)
        return;
    const std::size_t limit = direction == StepDirection::Forward ? end() : 0;
    seek(navigation().breakpointFrom(position(), limit, m_breakpoints, direction).value_or(limit));
}

void Playhead::runToPickedPixel(StepDirection direction)
{
    if (!m_traced)
        return;
    if (!m_picked) {
        emit message(tr("No pixel is picked: click one in the pixel grid or press an arrow key."));
        return;
    }
    if (const auto write = navigation().writeOf(*m_picked, position(), direction)) {
        seek(*write);
        return;
    }
    const QString text = direction == StepDirection::Forward
        ? tr("No later step writes pixel (%1, %2).")
        : tr("No earlier step writes pixel (%1, %2).");
    emit message(text.arg(m_picked->x()).arg(m_picked->y()));
}

void Playhead::pick(const QPoint &pixel)
{
    if (!m_traced)
        return;
    if (setPicked(pixel))
        emit pickedPixelChanged();
    emit pixelChosen(*m_picked);
}

void Playhead::setForetold(bool isForetold)
{
    m_isForetold = isForetold;
    tellAhead();
}

Ahead Playhead::aheadAt(std::size_t position) const
{
    return m_isForetold && position < end() ? Ahead::Hidden : Ahead::Shown;
}

void Playhead::tellAhead()
{
    if (m_toldAhead == ahead())
        return;
    m_toldAhead = ahead();
    emit aheadHiddenChanged(isAheadHidden());
}

void Playhead::nudgePick(int dx, int dy)
{
    if (!m_traced)
        return;
    const FrameSpec &frame = m_traced->scene.frame;
    const QPoint from = m_picked.value_or(QPoint(frame.firstColumn, frame.firstRow));
    if (setPicked(m_picked ? from + QPoint(dx, dy) : from))
        emit pickedPixelChanged();
}

void Playhead::toggleSpanBreakpoint(const SpanPlace &place)
{
    if (place.axis == SpanAxis::Free)
        return;
    std::set<std::int64_t> &places
        = place.axis == SpanAxis::Column ? m_breakpoints.columns : m_breakpoints.rows;
    if (!places.insert(place.coordinate).second)
        places.erase(place.coordinate);
    emit breakpointsChanged();
}

void Playhead::togglePixelBreakpoint(const QPoint &pixel)
{
    const std::pair<int, int> key(pixel.x(), pixel.y());
    if (!m_breakpoints.pixels.insert(key).second)
        m_breakpoints.pixels.erase(key);
    emit breakpointsChanged();
}

void Playhead::clearBreakpoints()
{
    if (m_breakpoints.isEmpty())
        return;
    m_breakpoints = {};
    emit breakpointsChanged();
}

void Playhead::moveTo(std::size_t position)
{
    if (!m_traced)
        return;
    const std::size_t target = std::min(position, end());
    const bool moved = target != m_cursor->position();
    if (moved)
        m_cursor->seek(target);
    bool pickMoved = false;
    // A span's first pixel is written only by the next step.
    const bool isTold = target > 0
        && (aheadAt(target) == Ahead::Shown
            || m_traced->trace->stepAt(target - 1).kind == StepKind::Sample);
    if (isTold) {
        if (const std::optional<QPoint> pixel = navigation().pixelOf(target - 1))
            pickMoved = setPicked(pixel);
    }
    tellAhead();
    if (moved)
        emit positionChanged(target);
    if (pickMoved)
        emit pickedPixelChanged();
}

bool Playhead::setPicked(std::optional<QPoint> pixel)
{
    if (pixel)
        pixel = clampedToFrame(*pixel);
    if (pixel == m_picked)
        return false;
    m_picked = pixel;
    return true;
}

QPoint Playhead::clampedToFrame(const QPoint &pixel) const
{
    const FrameSpec &frame = m_traced->scene.frame;
    return {std::clamp(pixel.x(), frame.firstColumn, frame.firstColumn + frame.width - 1),
            std::clamp(pixel.y(), frame.firstRow, frame.firstRow + frame.height - 1)};
}

} // namespace pixelplumb
