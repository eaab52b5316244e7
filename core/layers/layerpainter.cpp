// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layerpainter.h"

#include "core/layers/layermarks.h"
#include "core/layers/layertexts.h"

#include <QPainter>

#include <algorithm>

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

QStringList LayerPainter::paint(QPainter &painter, const LayerDrawing &drawing,
                                const LayerSurface &surface)
{
    QStringList omissions = paintMarks(painter, drawing, surface);
    omissions += paintLabels(painter, drawing, surface, {});
    return omissions;
}

QStringList LayerPainter::paintMarks(QPainter &painter, const LayerDrawing &drawing,
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
    const QString objection = LayerTexts(painter, surface, m_glyphs).paintCells(drawing.cells);
    for (const LayerDrawing::Point &point : drawing.points)
        marks.paint(point);
    painter.restore();
    return objection.isEmpty() ? QStringList() : QStringList(objection);
}

QStringList LayerPainter::paintLabels(QPainter &painter, const LayerDrawing &drawing,
                                      const LayerSurface &surface, std::span<const QRectF> taken)
{
    painter.save();
    painter.setClipRect(surface.view, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    LayerTexts texts(painter, surface, m_glyphs, taken);
    const auto omitted
        = std::ranges::count_if(drawing.labels, [&texts](const LayerDrawing::Label &label) {
              return texts.paint(label) == LayerTexts::Room::None;
          });
    painter.restore();
    m_labels.assign(texts.taken().begin() + std::ptrdiff_t(taken.size()), texts.taken().end());
    if (omitted == 0)
        return {};
    return {QStringLiteral("No room for %1 of %2 names: enlarge the picture, or show fewer layers")
                .arg(omitted)
                .arg(drawing.labels.size())};
}

} // namespace pixelplumb
