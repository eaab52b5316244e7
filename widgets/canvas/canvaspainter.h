// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerpainter.h"
#include "widgets/canvas/canvasscene.h"

namespace pixelplumb {

/// Paints the canvas. It caches the visible cells and their differences, so that a time step does
/// not look them all up again.
class CanvasPainter {
public:
    void paint(QPainter &painter, const CanvasScene &scene, const CanvasView &view,
               const QPalette &palette);

private:
    void paintCells(QPainter &painter, const CanvasScene &scene, const CanvasView &view,
                    const QPalette &palette);
    QImage cellsOf(const CanvasScene &scene, const ViewMapping &mapping, const QRect &device,
                   const QPalette &palette);

    QImage m_cells; ///< those in view, in device pixels
    CanvasDifferences m_differences;
    LayerPainter m_layers;
};

} // namespace pixelplumb
