// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"

namespace pixelplumb {

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

private:
    QColor casing() const;
    void paintStroke(const QLineF &line, const QColor &colour, Qt::PenStyle style);

    QPainter &m_painter;
    const LayerSurface &m_surface;
};

} // namespace pixelplumb
