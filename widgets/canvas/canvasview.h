// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"
#include "widgets/model/scenedocument.h"

#include <QRectF>

class QWidget;

namespace pixelplumb {

/// Where the frame and its rulers stand on the canvas, and how large the frame is seen. A zoom or
/// a move is kept until the whole frame is asked for; from then on it fits whatever the widget's
/// size is.
class CanvasView : public QObject {
    Q_OBJECT

public:
    CanvasView(const SceneDocument *document, QWidget *canvas);

    const ViewMapping &mapping() const { return m_mapping; }

    QRect bounds() const; ///< the widget's own
    /// The parts of the widget: where the frame is seen, and the rulers along two of its sides.
    QRectF area() const;
    QRectF columnRuler() const;
    QRectF rowRuler() const;

    /// The pixel drawn under a position; none outside the frame and on the rulers.
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    /// Where a point in the scene's coordinates is.
    QPointF positionOf(const LatticePoint &scenePoint) const;
    LatticePoint onSamples(const LatticePoint &scenePoint) const;
    LatticePoint fromSamples(const LatticePoint &samplePoint) const;
    /// Where a click would place a vertex, in the scene's coordinates.
    LatticePoint placeAt(const QPointF &position) const;

    /// Shows the whole frame as large as it fits, and goes on doing so.
    void fit();
    /// No smaller than needed to see the whole frame.
    void zoomTo(const ViewZoom &zoom, const QPointF &anchor);
    void moveBy(const QPoint &devicePixels);
    /// Brings a pixel that is not wholly seen to the middle, in the direction in which it is not.
    void reveal(const QPoint &pixel);

    void followFrame(); ///< the scene's
    void followSize(); ///< the widget's
    void followDevice(); ///< its place on the grid of device pixels, and their size

signals:
    void changed();
    void zoomChanged(int zoom); ///< see ViewZoom::number()

private:
    enum class Fit { Following, Free };

    ViewMapping fitted() const;
    void setMapping(const ViewMapping &mapping);

    const SceneDocument *m_document;
    QWidget *m_canvas;
    ViewMapping m_mapping;
    Fit m_fit = Fit::Following;
};

} // namespace pixelplumb
