// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/stepping/scrubber.h"

#include "widgets/look/parts.h"
#include "widgets/model/steptext.h"

#include <chrono>
#include <limits>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr double clickReach = 4; // logical pixels
constexpr std::size_t mostBreakpoints = 1000; // more ticks could not be told apart

} // namespace

Sign signOf(MarkKind kind)
{
    switch (kind) {
    case MarkKind::PartBegins:
        return Sign::VertexMark;
    case MarkKind::Tie:
        return Sign::Tie;
    case MarkKind::Clamp:
        return Sign::Clamp;
    case MarkKind::FirstDifference:
        return Sign::FirstDifference;
    }
    return Sign::VertexMark;
}

Scrubber::Scrubber(Playhead *playhead, QWidget *parent)
    : QAbstractSlider(parent)
    , m_playhead(playhead)
{
    named(this, "scrubber", tr("Position in the run"));
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    onEvents(this, {QEvent::Resize, QEvent::PaletteChange, QEvent::FontChange},
             [this] { forgetBackground(); });
    m_seekTimer.setSingleShot(true);
    connect(&m_seekTimer, &QTimer::timeout, this, [this] { m_playhead->seek(m_sought); });
    connect(this, &QAbstractSlider::valueChanged, this, [this](int position) {
        if (std::size_t(position) != m_playhead->position())
            m_playhead->seek(std::size_t(position)); // from assistive technology
    });
    connect(playhead, &Playhead::tracedChanged, this, &Scrubber::takeTrace);
    connect(playhead, &Playhead::positionChanged, this, &Scrubber::followPlayhead);
    connect(playhead, &Playhead::aheadHiddenChanged, this, &Scrubber::forgetBackground);
    connect(playhead, &Playhead::breakpointsChanged, this, &Scrubber::findBreakpoints);
    takeTrace();
}

const TraceMark *Scrubber::markNear(double x) const
{
    if (!m_playhead->traced())
        return nullptr;
    const std::vector<TraceMark> &marks = m_playhead->traced()->marks;
    const ScrubberScale toScreen = scale();
    const TraceMark *nearest = nullptr;
    double distance = clickReach;
    const std::size_t first = toScreen.positionAt(x - clickReach - 1);
    for (auto mark
         = std::ranges::lower_bound(marks, first > 0 ? first - 1 : 0, {}, &TraceMark::step);
         mark != marks.end(); ++mark) {
        const double offset = toScreen.xOf(mark->step + 1) - x;
        if (offset > clickReach)
            break;
        if (!isTold(*mark))
            continue;
        if (std::abs(offset) <= distance) {
            distance = std::abs(offset);
            nearest = &*mark;
        }
    }
    return nearest;
}

/// Whether a mark may be shown: all but a part's beginning reveal what a step will compute.
bool Scrubber::isTold(const TraceMark &mark) const
{
    return !m_playhead->isAheadHidden() || mark.step < m_playhead->position()
        || mark.kind == MarkKind::PartBegins;
}

void Scrubber::goToMark(StepDirection direction)
{
    if (!m_playhead->traced())
        return;
    const std::vector<TraceMark> &marks = m_playhead->traced()->marks;
    // A mark's position is just after its step.
    const std::size_t position = m_playhead->position();
    if (direction == StepDirection::Forward) {
        const auto next = std::ranges::lower_bound(marks, position, {}, &TraceMark::step);
        m_playhead->seek(next == marks.end() ? m_playhead->end() : next->step + 1);
        return;
    }
    const auto notBefore = std::ranges::lower_bound(
        marks, position, {}, [](const TraceMark &mark) { return mark.step + 1; });
    m_playhead->seek(notBefore == marks.begin() ? 0 : std::prev(notBefore)->step + 1);
}

bool Scrubber::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        QToolTip::showText(help->globalPos(), hoverText(help->pos()), this);
        return true;
    }
    return QAbstractSlider::event(event);
}

void Scrubber::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !m_playhead->traced())
        return;
    m_playhead->setPlaying(false);
    setSliderDown(true);
    const double x = event->position().x();
    const TraceMark *mark = markNear(x);
    m_playhead->seek(mark ? mark->step + 1 : scale().positionAt(x));
}

void Scrubber::mouseMoveEvent(QMouseEvent *event)
{
    const double x = event->position().x();
    if (isSliderDown())
        seekSoon(scale().positionAt(x));
    if (isSliderDown() || QToolTip::isVisible())
        QToolTip::showText(event->globalPosition().toPoint(), hoverText(event->position()), this);
}

void Scrubber::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !isSliderDown())
        return;
    setSliderDown(false);
    if (m_seekTimer.isActive()) {
        m_seekTimer.stop();
        m_playhead->seek(m_sought);
    }
}

void Scrubber::keyPressEvent(QKeyEvent *event)
{
    const bool byMark = event->modifiers() & Qt::ControlModifier;
    const auto go = [&](StepUnit unit, StepDirection direction) {
        if (byMark)
            goToMark(direction);
        else
            m_playhead->step(unit, direction);
    };
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
        return go(m_playhead->unit(), StepDirection::Backward);
    case Qt::Key_Right:
    case Qt::Key_Up:
        return go(m_playhead->unit(), StepDirection::Forward);
    case Qt::Key_PageUp:
        return m_playhead->step(StepUnit::Span, StepDirection::Backward);
    case Qt::Key_PageDown:
        return m_playhead->step(StepUnit::Span, StepDirection::Forward);
    case Qt::Key_Home:
        return m_playhead->seek(0);
    case Qt::Key_End:
        return m_playhead->seek(m_playhead->end());
    default:
        QWidget::keyPressEvent(event);
    }
}

void Scrubber::wheelEvent(QWheelEvent *event)
{
    const int turned = event->angleDelta().y();
    if (turned != 0)
        m_playhead->step(m_playhead->unit(),
                         turned < 0 ? StepDirection::Forward : StepDirection::Backward);
    event->accept();
}

void Scrubber::takeTrace()
{
    const std::size_t end = m_playhead->end();
    {
        const QSignalBlocker blocker(this);
        setRange(0, int(std::min(end, std::size_t(std::numeric_limits<int>::max()))));
    }
    findStops();
    findBreakpoints();
    followPlayhead();
}

void Scrubber::followPlayhead()
{
    const QSignalBlocker blocker(this);
    setValue(int(m_playhead->position()));
    if (const TracedScene *traced = m_playhead->traced())
        setAccessibleDescription(stepText(*traced, m_playhead->position()));
    if (m_playhead->isAheadHidden())
        forgetBackground(); // marks that were ahead may be shown now
    update();
}

void Scrubber::findBreakpoints()
{
    m_breakpoints.clear();
    if (const TracedScene *traced = m_playhead->traced()) {
        const TraceNavigation navigation(*traced->trace);
        const Breakpoints &breakpoints = m_playhead->breakpoints();
        std::size_t position = 0;
        while (m_breakpoints.size() < mostBreakpoints) {
            const auto next = navigation.breakpointFrom(position, m_playhead->end(), breakpoints,
                                                        StepDirection::Forward);
            if (!next)
                break;
            position = *next;
            m_breakpoints.push_back(position);
        }
    }
    forgetBackground();
}

void Scrubber::setColumnPlaces(const ColumnPlaces &places)
{
    m_places = places;
    findStops();
}

void Scrubber::findStops()
{
    m_stops.clear();
    forgetBackground();
    const bool areColumnsPlaced = m_places.width > 0 && m_places.right > m_places.left;
    if (!areColumnsPlaced || !m_playhead->traced()
        || m_playhead->traced()->trace->primitiveCount() != 1)
        return;
    const ScanTrace &trace = *m_playhead->traced()->trace;
    std::vector<ColumnStop> stops;
    for (std::size_t span = 0; span < trace.spanCount(); ++span) {
        const SpanPlace &place = trace.placeOf(span);
        const double x = m_places.origin + m_places.width * double(place.coordinate);
        const bool ascends = stops.empty() || x >= stops.back().x;
        if (place.axis != SpanAxis::Column || !ascends)
            return;
        stops.push_back({trace.indexOfSpan(span) + 1, x});
    }
    m_stops = std::move(stops);
}

void Scrubber::forgetBackground()
{
    m_background = {};
    update();
}

void Scrubber::seekSoon(std::size_t position)
{
    m_sought = position;
    if (!m_seekTimer.isActive())
        m_seekTimer.start(16ms);
}

QString Scrubber::hoverText(const QPointF &at) const
{
    const TracedScene *traced = m_playhead->traced();
    if (!traced)
        return {};
    if (const QString meaning = nameText(at); !meaning.isEmpty())
        return meaning;
    const TraceMark *mark = markNear(at.x());
    const std::size_t position = mark ? mark->step + 1 : scale().positionAt(at.x());
    const bool isAhead = m_playhead->isAheadHidden() && position > m_playhead->position();
    const QString step
        = tr("step %1: %2")
              .arg(position)
              .arg(isAhead ? tr("still ahead, predict it") : stepText(*traced, position));
    return mark ? step + QLatin1Char('\n') + markText(*traced, *mark) : step;
}

} // namespace pixelplumb
