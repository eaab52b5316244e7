// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/ruler.h"

#include "core/scene/scene.h"

#include <QtWidgets>

#include <cmath>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

// Logical pixels.
constexpr double labelledTickLength = 6;
constexpr double plainTickLength = 3;
constexpr double leastTickSpacing = 4;
constexpr double gap = 2;
constexpr double markRadius = 4;

QString tickText(std::int64_t value)
{
    const QString digits = QString::number(std::abs(value));
    return value < 0 ? QChar(0x2212) + digits : digits;
}

double offsetInPixels(const FrameSpec &frame)
{
    return double(sampleOffset(frame)) / unitsPerPixel;
}

} // namespace

std::int64_t rulerStep(double pixelLength, double leastLength)
{
    std::int64_t power = 1;
    while (true) {
        for (const std::int64_t factor : {1, 2, 5}) {
            if (double(factor * power) * pixelLength >= leastLength || power > largestPixel)
                return factor * power;
        }
        power *= 10;
    }
}

std::vector<RulerTick> rulerTicks(double first, double last, double pixelLength,
                                  double leastLabelLength, double leastTickLength)
{
    const std::int64_t labelStep = rulerStep(pixelLength, leastLabelLength);
    std::int64_t tickStep = rulerStep(pixelLength, leastTickLength);
    while (labelStep % tickStep != 0) // 5 is not a multiple of 2: the ticks would miss the labels
        tickStep = rulerStep(pixelLength, double(tickStep + 1) * pixelLength);

    std::vector<RulerTick> ticks;
    const std::int64_t begin = ceilDivide(std::int64_t(std::ceil(first)), tickStep) * tickStep;
    for (std::int64_t value = begin; double(value) <= last; value += tickStep)
        ticks.push_back({value, value % labelStep == 0 ? TickKind::Labelled : TickKind::Plain});
    return ticks;
}

Ruler::Ruler(Qt::Orientation orientation, const QRectF &rect, const ViewMapping &mapping)
    : m_orientation(orientation)
    , m_rect(rect)
    , m_mapping(mapping)
{
}

void Ruler::paint(QPainter &painter, const QPalette &palette,
                  std::span<const RulerMark> marks) const
{
    painter.save();
    painter.setClipRect(m_rect);
    painter.fillRect(m_rect, palette.color(QPalette::Window));

    const double pixelLength = m_mapping.zoom().factor() / m_mapping.devicePixelRatio();
    const QFontMetricsF metrics(painter.font());
    const double labelLength = isHorizontal() ? metrics.horizontalAdvance(u"−0000"_s) + 6 * gap
                                              : metrics.height() + 6 * gap;
    const double offset = offsetInPixels(m_mapping.frame());
    const double start = isHorizontal() ? m_rect.left() : m_rect.top();
    const double end = isHorizontal() ? m_rect.right() : m_rect.bottom();
    // Sample coordinates grow along the ruler or against it, linearly.
    const double zero = along(0);
    const double direction = along(1) < zero ? -1 : 1;
    const double one = (start - zero) / (direction * pixelLength);
    const double other = (end - zero) / (direction * pixelLength);
    const QColor ink = translucent(palette.color(QPalette::WindowText), 0.75);
    painter.setPen(QPen(ink, 1));
    for (const RulerTick &tick :
         rulerTicks(std::min(one, other) + offset - 1, std::max(one, other) + offset + 1,
                    pixelLength, labelLength, leastTickSpacing))
        paintTick(painter, tick);
    for (const RulerMark &mark : marks)
        paintMark(painter, palette, mark);
    painter.restore();
}

double Ruler::along(double sample) const
{
    const FrameSpec &frame = m_mapping.frame();
    // Relative to the first pixel, so that far frames keep their fractions.
    const QPointF position = isHorizontal() ? m_mapping.positionOf(sample, frame.firstRow)
                                            : m_mapping.positionOf(frame.firstColumn, sample);
    return isHorizontal() ? position.x() : position.y();
}

double Ruler::innerSide() const
{
    if (!isHorizontal())
        return m_rect.right();
    return m_mapping.frame().origin == FrameOrigin::BottomLeft ? m_rect.top() : m_rect.bottom();
}

double Ruler::outward() const
{
    return isHorizontal() && m_mapping.frame().origin == FrameOrigin::BottomLeft ? 1 : -1;
}

void Ruler::paintTick(QPainter &painter, const RulerTick &tick) const
{
    const double length = tick.kind == TickKind::Labelled ? labelledTickLength : plainTickLength;
    // At the middle of a device pixel, where a line one pixel wide is sharp.
    const double ratio = m_mapping.devicePixelRatio();
    const double at
        = (std::floor(along(double(tick.value) - offsetInPixels(m_mapping.frame())) * ratio) + 0.5)
        / ratio;
    const double inner = innerSide();
    const double outer = inner + outward() * length;
    if (isHorizontal())
        painter.drawLine(QPointF(at, inner), QPointF(at, outer));
    else
        painter.drawLine(QPointF(inner, at), QPointF(outer, at));
    if (tick.kind != TickKind::Labelled)
        return;

    const QFontMetricsF metrics(painter.font());
    const QString text = tickText(tick.value);
    const double labelEnd = outer + outward() * gap;
    QRectF label({}, QSizeF(metrics.horizontalAdvance(text), metrics.height()));
    if (isHorizontal())
        label.moveTo(at - label.width() / 2, outward() > 0 ? labelEnd : labelEnd - label.height());
    else
        label.moveTo(labelEnd - label.width(), at - label.height() / 2);
    const bool isWhole = isHorizontal()
        ? label.left() >= m_rect.left() && label.right() <= m_rect.right()
        : label.top() >= m_rect.top() && label.bottom() <= m_rect.bottom();
    if (isWhole) // a clipped number would be another number
        painter.drawText(label, Qt::AlignCenter | Qt::TextDontClip, text);
}

void Ruler::paintMark(QPainter &painter, const QPalette &palette, const RulerMark &mark) const
{
    const double at = along(mark.sample);
    const double inner = innerSide();
    const auto point = [this](double alongRuler, double across) {
        return isHorizontal() ? QPointF(alongRuler, across) : QPointF(across, alongRuler);
    };
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(signColour(mark.sign, palette));
    if (mark.sign == Sign::Breakpoint) {
        const QPointF centre = point(at, inner + outward() * (labelledTickLength + markRadius));
        painter.setPen(QPen(palette.color(QPalette::Window), 1));
        painter.drawEllipse(centre, markRadius + 0.5, markRadius + 0.5);
    } else {
        // A plumb bob whose tip points at the frame.
        QPainterPath bob(point(at, inner));
        bob.lineTo(point(at - markRadius, inner + outward() * 2 * markRadius));
        bob.lineTo(point(at + markRadius, inner + outward() * 2 * markRadius));
        bob.closeSubpath();
        painter.drawPath(bob);
    }
    painter.restore();
}

double columnRulerHeight(const QFontMetricsF &metrics)
{
    return std::ceil(metrics.height() + labelledTickLength + 2 * gap);
}

double rowRulerWidth(const QFontMetricsF &metrics, const FrameSpec &frame)
{
    double widest = metrics.horizontalAdvance(u"−00"_s);
    for (const std::int64_t row :
         {std::int64_t(frame.firstRow), std::int64_t(frame.firstRow) + frame.height})
        widest = std::max(widest, metrics.horizontalAdvance(tickText(row)));
    return std::ceil(widest + labelledTickLength + 3 * gap);
}

} // namespace pixelplumb
