// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/steptext.h"
#include "widgets/stepping/scrubber.h"

#include <array>

namespace pixelplumb {

namespace {

// All in logical pixels.
constexpr int margin = 8;
constexpr int gutter = 72; // left of the lanes, for their names
constexpr int laneHeight = 11;
constexpr int laneCount = 4;
constexpr int trackTop = margin / 2 + laneCount * laneHeight;
constexpr int trackHeight = 14;
constexpr int wholeHeight = trackTop + trackHeight + margin / 2 + 2;
constexpr double leastSpanWidth = 4; // narrower spans have no ticks
constexpr double leastGlyphDistance = 8;

} // namespace

QSize Scrubber::sizeHint() const { return {640, wholeHeight}; }

QSize Scrubber::minimumSizeHint() const { return {240, wholeHeight}; }

ScrubberScale Scrubber::scale() const
{
    if (!m_stops.empty()) {
        // One column before the first is the start, half a column after the last the end.
        const double left = m_stops.front().x - m_places.width;
        return {left, m_stops.back().x + m_places.width / 2 - left, m_playhead->end(), m_stops};
    }
    return {double(gutter), double(std::max(1, width() - gutter - margin)), m_playhead->end()};
}

void Scrubber::paintEvent(QPaintEvent *)
{
    if (m_background.isNull())
        paintBackground();
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_background);
    if (!m_playhead->traced())
        return;

    painter.setRenderHint(QPainter::Antialiasing);
    paintPosition(painter);
    if (hasFocus()) {
        QStyleOptionFocusRect focus;
        focus.initFrom(this);
        focus.rect = rect().adjusted(1, 1, -1, -1);
        focus.backgroundColor = palette().color(QPalette::Window);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, &painter, this);
    }
}

/// Draws the position; where the view excludes its column, an arrow points to that side.
void Scrubber::paintPosition(QPainter &painter) const
{
    const ScrubberScale toScreen = scale();
    const double x = toScreen.xOf(m_playhead->position());
    const QColor plumbLine = signColour(Sign::CurrentColumn, palette());
    const QColor done = translucent(plumbLine, 0.3);
    const double left = std::max(toScreen.left, double(gutter));
    const double doneWidth = std::min(x, double(width())) - left;
    painter.fillRect(QRectF(left, trackTop + 5, std::max(0.0, doneWidth), 4), done);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plumbLine);
    const bool isLeft = !m_stops.empty() && x < m_places.left;
    const bool isRight = !m_stops.empty() && x > m_places.right;
    if (isLeft || isRight) {
        const double tip = isLeft ? m_places.left + 2 : m_places.right - 2;
        const double back = tip + (isLeft ? 8 : -8);
        painter.drawPolygon(
            QPolygonF({{tip, trackTop + 7.0}, {back, trackTop + 1.0}, {back, trackTop + 13.0}}));
        return;
    }
    painter.drawPolygon(QPolygonF({{x - 5, trackTop + 1.0},
                                   {x + 5, trackTop + 1.0},
                                   {x + 5, trackTop + 8.0},
                                   {x, trackTop + double(trackHeight)},
                                   {x - 5, trackTop + 8.0}}));
    painter.setPen(QPen(plumbLine, 1.5));
    painter.drawLine(QPointF(x, margin / 2), QPointF(x, trackTop + trackHeight));
}

void Scrubber::paintBackground()
{
    m_background = QPixmap(size() * devicePixelRatioF());
    m_background.setDevicePixelRatio(devicePixelRatioF());
    m_background.fill(palette().color(QPalette::Window));
    QPainter painter(&m_background);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter.setFont(small);
    paintLane(painter, 0, MarkKind::PartBegins, tr("vertices"));
    paintLane(painter, 1, MarkKind::Tie, tr("ties"));
    paintLane(painter, 2, MarkKind::Clamp, tr("clamps"));
    paintLane(painter, 3, MarkKind::FirstDifference, tr("first"));
    paintTrack(painter);
}

QString Scrubber::nameText(const QPointF &position) const
{
    const auto lane = int((position.y() - margin / 2.0) / laneHeight);
    if (position.x() >= gutter - margin || lane < 0 || lane >= laneCount)
        return {};
    constexpr std::array kinds // from above
        = {MarkKind::PartBegins, MarkKind::Tie, MarkKind::Clamp, MarkKind::FirstDifference};
    const MarkKind kind = kinds[std::size_t(lane)];
    return kind == MarkKind::FirstDifference
        ? tr("first: here is the first pixel that differs from the truth")
        : markText(*m_playhead->traced(), {0, kind});
}

/// The area right of the names.
QRectF Scrubber::lanes() const
{
    return {double(gutter - margin), 0, double(width() - gutter + margin), double(height())};
}

void Scrubber::paintName(QPainter &painter, double top, double height, const QString &name) const
{
    painter.setPen(translucent(palette().color(QPalette::WindowText), 0.75));
    painter.drawText(QRectF(0, top, gutter - margin - 2, height), Qt::AlignRight | Qt::AlignVCenter,
                     name);
}

void Scrubber::paintLane(QPainter &painter, int lane, MarkKind kind, const QString &name) const
{
    const ScrubberScale toScreen = scale();
    const double top = margin / 2.0 + lane * laneHeight;
    const double middle = top + laneHeight / 2.0;
    const Sign sign = signOf(kind);
    const QString glyph = signGlyph(sign);
    paintName(painter, top, laneHeight, glyph.isEmpty() ? name : name + QLatin1Char(' ') + glyph);
    painter.save();
    painter.setClipRect(lanes());
    painter.setPen(QPen(translucent(palette().color(QPalette::WindowText), 0.2), 1));
    painter.drawLine(QPointF(toScreen.left, middle),
                     QPointF(toScreen.left + toScreen.width, middle));
    paintMarks(painter, top, kind);
    painter.restore();
}

void Scrubber::paintMarks(QPainter &painter, double top, MarkKind kind) const
{
    const ScrubberScale toScreen = scale();
    const double middle = top + laneHeight / 2.0;
    const Sign sign = signOf(kind);
    const QString glyph = signGlyph(sign);
    if (!m_playhead->traced())
        return;
    const QColor colour = signColour(sign, palette());
    painter.setPen(QPen(colour, 1.2));
    double lastTick = -1;
    double lastGlyph = -leastGlyphDistance;
    for (const TraceMark &mark : m_playhead->traced()->marks) {
        const double x = toScreen.xOf(mark.step + 1);
        if (mark.kind != kind || !isTold(mark) || x - lastTick < 1)
            continue;
        lastTick = x;
        const bool isDiamond = glyph.isEmpty();
        if (x - lastGlyph < leastGlyphDistance) {
            painter.drawLine(QPointF(x, middle - 2), QPointF(x, middle + 2));
            continue;
        }
        lastGlyph = x;
        if (isDiamond) {
            painter.setBrush(colour);
            painter.drawPolygon(
                QPolygonF({{x, middle - 4}, {x + 4, middle}, {x, middle + 4}, {x - 4, middle}}));
            painter.setBrush(Qt::NoBrush);
        } else {
            const QRectF cell(x - 6, top, 12, laneHeight);
            painter.fillRect(cell.adjusted(2, 0, -2, 0), palette().color(QPalette::Window));
            painter.drawText(cell, Qt::AlignCenter, glyph);
        }
    }
}

void Scrubber::paintTrack(QPainter &painter) const
{
    const ScrubberScale toScreen = scale();
    paintName(painter, trackTop, trackHeight, tr("spans"));
    painter.setClipRect(lanes());
    painter.fillRect(QRectF(toScreen.left, trackTop + 5, toScreen.width, 4),
                     translucent(palette().color(QPalette::WindowText), 0.2));
    const TracedScene *traced = m_playhead->traced();
    if (!traced)
        return;
    const ScanTrace &trace = *traced->trace;
    if (trace.spanCount() > 0 && toScreen.width / double(trace.spanCount()) >= leastSpanWidth) {
        painter.setPen(QPen(translucent(palette().color(QPalette::WindowText), 0.2), 1));
        for (std::size_t span = 0; span < trace.spanCount(); ++span) {
            const std::size_t position = trace.indexOfSpan(span) + 1;
            // How far apart those ahead are tells how many samples they have.
            if (m_playhead->isAheadHidden() && position > m_playhead->position())
                break;
            const double x = toScreen.xOf(position);
            painter.drawLine(QPointF(x, trackTop + 3), QPointF(x, trackTop + 11));
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(signColour(Sign::Breakpoint, palette()));
    for (const std::size_t position : m_breakpoints)
        painter.drawEllipse(QPointF(toScreen.xOf(position), trackTop + 7), 3.5, 3.5);
}

} // namespace pixelplumb
