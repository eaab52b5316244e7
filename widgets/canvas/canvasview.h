// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/viewmapping.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

#include <optional>

namespace pixelplumb {

class CanvasMouse;
class Playhead;
struct TracedScene;

/// Where in its device pixel a widget's corner lies, as ViewMapping asks.
QPointF fractionOf(const QWidget &widget);

/// Where the frame and its rulers are on the canvas, and at what zoom. A zoom or move is kept until
/// the whole frame is asked for; from then on the frame fits the widget at any size.
class CanvasView : public QObject {
    Q_OBJECT

public:
    CanvasView(const SceneDocument *document, QWidget *canvas);

    const ViewMapping &mapping() const { return m_mapping; }

    QRect bounds() const; ///< the widget's own
    /// The parts of the widget: the area that shows the frame, and the rulers along two of its
    /// sides.
    QRectF area() const;
    QRectF columnRuler() const;
    QRectF rowRuler() const;

    /// The pixel drawn under a position; none outside the frame and on the rulers.
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    /// The widget position of a point in the scene's coordinates.
    QPointF positionOf(const LatticePoint &scenePoint) const;
    LatticePoint onSamples(const LatticePoint &scenePoint) const;
    LatticePoint fromSamples(const LatticePoint &samplePoint) const;
    /// Where a click would place a vertex, in the scene's coordinates.
    LatticePoint placeAt(const QPointF &position) const;

    /// Shows the whole frame as large as it fits, and keeps it so.
    void fit();
    /// Zooms out no farther than 1:1 or than the whole frame needs.
    void zoomTo(const ViewZoom &zoom, const QPointF &anchor);
    void moveBy(const QPoint &devicePixels);
    /// Centres a pixel that is not wholly visible, in those directions in which it is not.
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

/// Moves the canvas's view when a step, a choice or a run leads to a pixel outside it. The run of
/// an edited scene does not move the view under the pointer.
class ViewFollower : public QObject {
    Q_OBJECT

public:
    ViewFollower(CanvasView &view, CanvasMouse &mouse, const Playhead *playhead);

private:
    /// What a person looks at.
    struct Moment {
        const TracedScene *traced = nullptr;
        std::size_t position = 0;
        std::optional<QPoint> picked;

        bool operator==(const Moment &) const = default;
    };

    void follow();
    std::optional<QPoint> pixelSince(const Moment &before) const;

    CanvasView &m_view;
    CanvasMouse &m_mouse;
    const Playhead *m_playhead;
    Moment m_moment;
};

} // namespace pixelplumb
