// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerpainter.h"

#include "core/layers/layermarks.h"
#include "core/layers/layertexts.h"

#include <QPainter>

namespace pixelplumb {

QTransform pictureTransform(const FrameSpec &frame, const QPointF &corner, double cell)
{
    const bool upward = frame.origin == FrameOrigin::BottomLeft;
    const double down = upward ? frame.height - 0.5 + frame.firstRow : 0.5 - frame.firstRow;
    return {cell,
            0,
            0,
            upward ? -cell : cell,
            corner.x() + (0.5 - frame.firstColumn) * cell,
            corner.y() + down * cell};
}

void LayerPainter::paint(QPainter &painter, const LayerDrawing &drawing,
                         const LayerSurface &surface)
{
    painter.save();
    painter.setClipRect(surface.view, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    LayerMarks marks(painter, surface);
    for (const LayerDrawing::Area &area : drawing.areas)
        marks.paint(area);
    for (const LayerDrawing::Line &line : drawing.lines)
        marks.paint(line);
    for (const LayerDrawing::Circle &circle : drawing.circles)
        marks.paint(circle);
    LayerTexts texts(painter, surface, m_glyphs);
    texts.paintCells(drawing.cells);
    for (const LayerDrawing::Point &point : drawing.points)
        marks.paint(point);
    for (const LayerDrawing::Label &label : drawing.labels)
        texts.paint(label);
    painter.restore();
}

} // namespace pixelplumb
