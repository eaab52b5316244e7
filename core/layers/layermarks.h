// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

namespace pixelplumb {

/// Radius of a point, logical px; small cells get smaller ones.
inline constexpr double largestPointRadius = 3.5;

/// Width of what is visible beside a line along it, logical px.
inline constexpr double bandWidth = 6;

/// A vector of this length to the right of a measure's way on the screen, in the paint device.
QPointF besideMeasure(const LayerDrawing::Measure &measure, const LayerSurface &surface,
                      double length);
/// The line of a measure, in the paint device.
QLineF measureLine(const LayerDrawing::Measure &measure, const LayerSurface &surface);
/// The line of a measure with its ticks.
QRectF measureRect(const LayerDrawing::Measure &measure, const LayerSurface &surface);

/// Paints everything in a drawing but text.
class LayerMarks {
public:
    LayerMarks(QPainter &painter, const LayerSurface &surface)
        : m_painter(painter)
        , m_surface(surface)
    {
    }

    void paint(const LayerDrawing::Area &area);
    void paint(const LayerDrawing::Line &line);
    void paint(const LayerDrawing::Circle &circle);
    void paint(const LayerDrawing::Point &point);
    void paint(const LayerDrawing::Measure &measure);

private:
    QColor casing() const;
    void paintStroke(const QLineF &line, const QPen &pen);

    QPainter &m_painter;
    const LayerSurface &m_surface;
};

} // namespace pixelplumb
