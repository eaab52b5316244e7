// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

namespace pixelplumb {

/// Of a point, logical px; small cells have room for smaller ones alone.
inline constexpr double largestPointRadius = 3.5;

/// Of what is seen beside a line that lies along it, logical px.
inline constexpr double bandWidth = 6;

/// Towards the right of a measure's way as seen, in the paint device: so long.
QPointF besideMeasure(const LayerDrawing::Measure &measure, const LayerSurface &surface,
                      double length);
/// Where the line of a measure is, in the paint device.
QLineF measureLine(const LayerDrawing::Measure &measure, const LayerSurface &surface);
/// That and its ticks.
QRectF measureRect(const LayerDrawing::Measure &measure, const LayerSurface &surface);

/// Paints what of a drawing is no text.
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
