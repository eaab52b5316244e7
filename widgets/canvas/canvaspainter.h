// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/layers/layerpainter.h"
#include "core/runs/ahead.h"
#include "widgets/canvas/canvasscene.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/viewmapping.h"

#include <QtGui>

#include <memory>

namespace pixelplumb {

struct LayerView;

/// What the enabled layers draw at the shown moment. It is collected anew when one of these
/// changes, not at every move of the pointer.
class CanvasLayers {
public:
    /// Adds nothing while the run is not the scene's own, and while the truth is shown instead of
    /// the frame.
    void addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view);

private:
    /// What the drawing depends on.
    struct Moment {
        std::shared_ptr<const TracedScene> traced;
        std::size_t position = 0;
        QStringList layers;
        ViewMapping mapping;
        QRectF area;
        std::optional<QPoint> picked;
        std::optional<AffineImage> image;
        Ahead ahead = Ahead::Shown;

        friend bool operator==(const Moment &, const Moment &) = default;
    };

    Moment m_moment;
    LayerDrawing m_drawing;
};

/// Enlarges or thins out the part of a picture that a rectangle of device pixels shows: each device
/// pixel copies the one pixel that ViewMapping::pixelAt finds there. The cost depends on the size
/// of the rectangle, not of the picture.
///
/// `device` must lie inside mapping.devicePicture(). `shown` takes the rectangle's size and reuses
/// its memory where the size is unchanged.
void enlargePicture(const QImage &picture, const ViewMapping &mapping, const QRect &device,
                    QImage &shown);

/// Writes the pixels' bytes into their cells, where these have room and are few enough to be read.
/// `area`: the visible part of the widget.
void drawValues(QPainter &painter, const FrameBuffer &frame, const ViewMapping &mapping,
                const QRectF &area, ByteNotation notation);

/// Draws the grid lines into an enlarged picture, on the first device pixels of each cell.
void blendGrid(QImage &shown, const ViewMapping &mapping, const QRect &device,
               const QColor &colour);

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
