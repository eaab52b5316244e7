// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvaskeys.h"
#include "widgets/canvas/canvasmouse.h"
#include "widgets/canvas/canvaspainter.h"
#include "widgets/canvas/canvasscene.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/canvas/pointerreadout.h"

#include <QtWidgets>

namespace pixelplumb {

/// The frame as it is at the playhead's position, with all editing by pointing: vertices are
/// placed, dragged and selected, pixels picked, columns sought on the ruler. Outlines and handles
/// come straight from the document, so that they never lag behind the pointer; cells and signs come
/// from the traced scene, the cells from a preview where the trace takes long or was cut.
///
/// The widget only delegates: CanvasView knows where things are, CanvasScene what is shown,
/// CanvasPainter draws it, and CanvasMouse and CanvasKeys handle the input.
class Canvas : public QWidget {
    Q_OBJECT

public:
    Canvas(SceneDocument *document, Playhead *playhead, DisplayOptions *options,
           QWidget *parent = nullptr);
    ~Canvas() override;

    /// Previews stand in for a run that is not there yet.
    void setPreviewer(const ScenePreviewer *previewer);
    /// While an effect is forced, the canvas marks what that changes instead of what differs from
    /// the truth.
    void setEffects(const EffectSwitches *effects);
    /// While there is a student's picture, its differences are marked instead of those from the
    /// truth.
    void setStudentPicture(const StudentPicture *student);

    const ViewMapping &mapping() const { return m_view.mapping(); }
    /// The part of the widget where the frame is seen.
    QRectF view() const { return m_view.area(); }
    QRectF columnRuler() const { return m_view.columnRuler(); }
    QRectF rowRuler() const { return m_view.rowRuler(); }
    /// Device pixels per frame pixel; below 1:1 the negative of frame pixels per device pixel.
    int zoom() const { return mapping().zoom().number(); }

    /// The pixel drawn under a position; none outside the frame and on the rulers.
    std::optional<QPoint> pixelAt(const QPointF &position) const
    {
        return m_view.pixelAt(position);
    }
    /// The middle of a pixel's cell.
    QPointF positionOf(const QPoint &pixel) const { return mapping().positionOf(pixel); }
    /// The widget position of a point in the scene's coordinates.
    QPointF positionOf(const LatticePoint &scenePoint) const
    {
        return m_view.positionOf(scenePoint);
    }
    /// Where a click would place a vertex, in the scene's coordinates.
    LatticePoint placeAt(const QPointF &position) const { return m_view.placeAt(position); }
    /// The vertex whose handle is under a position.
    std::optional<VertexRef> vertexAt(const QPointF &position) const;

    CanvasTool tool() const { return m_mouse.tool(); }
    /// The text beside the pointer: "(27, 19) #a06f30" and what painted the pixel, a line each;
    /// before them the place of the vertex that a click would place, where that is no pixel. Empty
    /// where the pointer is not over the frame, and while a button is drawing.
    QString readout();

    bool isTruthVisible() const { return pixelplumb::isTruthVisible(m_sources, hand()); }
    /// What a screen reader says of the current pixel or vertex.
    QString spokenState() const;
    void announce(); ///< spokenState(), to screen readers
    /// The pointer has moved or left.
    void followPointer();

    QSize sizeHint() const override { return {720, 560}; }
    /// 48 rows at zoom 2 with the ruler: in a low window a study below needs the rest.
    QSize minimumSizeHint() const override { return {240, 144}; }

public slots:
    void setTool(pixelplumb::CanvasTool tool);
    void setZoom(int zoom);
    void zoomIn();
    void zoomOut();
    /// Shows the whole frame as large as it fits, and keeps it so while the widget is resized.
    void fitToView();
    void editCoordinates(const pixelplumb::VertexRef &ref);

signals:
    void toolChanged(pixelplumb::CanvasTool tool);
    void zoomChanged(int zoom);
    void viewChanged(); ///< the zoom or the place of the frame
    /// The pixel under the pointer, inside the frame or outside; none when the pointer leaves.
    void hovered(const std::optional<QPoint> &pixel);
    void colourRequested(const pixelplumb::VertexRef &ref);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void connectSources();
    void followScene();
    void updateSoon();
    void updateVertices();
    QPointF keyboardAnchor() const;
    CanvasHand hand() const;

    CanvasSources m_sources;
    CanvasView m_view;
    CanvasMouse m_mouse;
    CanvasKeys m_keys;
    ViewFollower m_follower;
    ImageFollower m_imageFollower;
    OutlineChoice m_outlines;
    CanvasLayers m_layers;
    CanvasPainter m_painter;
    PointerReadout m_readout;
    /// Runs while the picture of a change is awaited.
    QTimer m_repaintTimer;
};

} // namespace pixelplumb
