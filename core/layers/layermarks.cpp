// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layermarks.h"

#include "core/layers/clippedline.h"

#include <QPainter>

#include <algorithm>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double lineWidth = 1.5;
constexpr double casingWidth = 1; ///< to each side
constexpr double arrowLength = 9;
constexpr double measureDistance = 12; ///< from what is measured
constexpr double tickLength = 5; ///< to each side
constexpr double measureWidth = 2;
constexpr double largestRadius = 1e5; ///< painters lose precision beyond
constexpr float tint = 0.22F;
constexpr float casingOpacity = 0.8F;

Qt::PenStyle penStyleOf(LayerDrawing::Stroke stroke)
{
    switch (stroke) {
    case LayerDrawing::Stroke::Dashed:
        return Qt::DashLine;
    case LayerDrawing::Stroke::Dotted:
        return Qt::DotLine;
    case LayerDrawing::Stroke::Solid:
    case LayerDrawing::Stroke::Arrow:
    case LayerDrawing::Stroke::Band:
        break;
    }
    return Qt::SolidLine;
}

} // namespace

QPointF besideMeasure(const LayerDrawing::Measure &measure, const LayerSurface &surface,
                      double length)
{
    const QLineF way(surface.fromSamples.map(measure.from),
                     surface.fromSamples.map(measure.from + measure.way));
    return QPointF(-way.dy(), way.dx()) / way.length() * length;
}

QLineF measureLine(const LayerDrawing::Measure &measure, const LayerSurface &surface)
{
    const QLineF way(surface.fromSamples.map(measure.from), surface.fromSamples.map(measure.to));
    return way.translated(besideMeasure(measure, surface, measureDistance));
}

QRectF measureRect(const LayerDrawing::Measure &measure, const LayerSurface &surface)
{
    const QLineF line = measureLine(measure, surface);
    const QPointF arm = besideMeasure(measure, surface, tickLength);
    return QRectF(line.p1() - arm, line.p2() + arm).normalized();
}

QColor LayerMarks::casing() const
{
    QColor colour = paperOf(m_surface.tone);
    colour.setAlphaF(casingOpacity);
    return colour;
}

void LayerMarks::paint(const LayerDrawing::Area &area)
{
    QPolygonF corners;
    for (const QPointF &corner : area.corners)
        corners.append(m_surface.fromSamples.map(corner));
    QColor colour = colourOf(area.ink, LayerTone::Dark); // the lighter one tints dark frames too
    colour.setAlphaF(tint);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(colour);
    m_painter.drawPolygon(corners);
}

void LayerMarks::paintStroke(const QLineF &line, const QPen &pen)
{
    const std::optional<QLineF> visible = clipped(line, m_surface.view.adjusted(-9, -9, 9, 9));
    if (!visible)
        return;
    m_painter.setPen(QPen(casing(), pen.widthF() + 2 * casingWidth, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(*visible);
    m_painter.setPen(pen);
    m_painter.drawLine(*visible);
}

void LayerMarks::paint(const LayerDrawing::Line &line)
{
    const QLineF shown(m_surface.fromSamples.map(line.from), m_surface.fromSamples.map(line.to));
    const QColor colour = colourOf(line.ink, m_surface.tone);
    const double width = line.stroke == LayerDrawing::Stroke::Band ? bandWidth : lineWidth;
    paintStroke(shown, QPen(colour, width, penStyleOf(line.stroke), Qt::FlatCap));
    if (line.stroke != LayerDrawing::Stroke::Arrow || shown.length() == 0)
        return;
    const QPointF back
        = (shown.p1() - shown.p2()) / shown.length() * std::min(arrowLength, shown.length());
    const QPointF aside = QPointF(-back.y(), back.x()) / 2;
    m_painter.setPen(QPen(casing(), casingWidth));
    m_painter.setBrush(colour);
    m_painter.drawPolygon(
        QPolygonF({shown.p2(), shown.p2() + back + aside, shown.p2() + back - aside}));
}

void LayerMarks::paint(const LayerDrawing::Circle &circle)
{
    const double radius = circle.radius * m_surface.fromSamples.m11();
    if (radius > largestRadius)
        return;
    const QPointF centre = m_surface.fromSamples.map(circle.centre);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(casing(), lineWidth + 2 * casingWidth));
    m_painter.drawEllipse(centre, radius, radius);
    m_painter.setPen(QPen(colourOf(circle.ink, m_surface.tone), lineWidth, Qt::DashLine));
    m_painter.drawEllipse(centre, radius, radius);
}

void LayerMarks::paint(const LayerDrawing::Point &point)
{
    const QPointF place = m_surface.fromSamples.map(point.place);
    if (!m_surface.view.adjusted(-9, -9, 9, 9).contains(place))
        return;
    m_painter.setPen(QPen(casing(), casingWidth));
    m_painter.setBrush(colourOf(point.ink, m_surface.tone));
    const double radius = std::clamp(m_surface.fromSamples.m11() / 5, 1.0, largestPointRadius);
    m_painter.drawEllipse(place, radius, radius);
}

void LayerMarks::paint(const LayerDrawing::Measure &measure)
{
    const QLineF shown = measureLine(measure, m_surface);
    const QPen pen(colourOf(measure.ink, m_surface.tone), measureWidth, Qt::SolidLine, Qt::FlatCap);
    const QPointF arm = besideMeasure(measure, m_surface, tickLength);
    for (const QPointF &end : {shown.p1(), shown.p2()})
        paintStroke({end - arm, end + arm}, pen);
    paintStroke(shown, pen);
}

} // namespace pixelplumb
