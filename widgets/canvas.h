// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvasdifferences.h"
#include "widgets/canvasgesture.h"
#include "widgets/outlinechoice.h"
#include "widgets/scenedocument.h"
#include "widgets/viewmapping.h"

#include <QTimer>
#include <QWidget>

namespace pixelplumb {

class DisplayOptions;
class FramePainter;
class Playhead;
class ScenePreviewer;

/// The frame as it stands at the playhead's position, with everything that a person may do to the
/// scene by pointing: vertices are placed, dragged and chosen, pixels picked, columns sought on the
/// ruler. Outlines and handles come straight from the document, so that they never lag behind the
/// hand; cells and signs come from the traced scene, the cells from a preview where its trace takes
/// long or was cut.
class Canvas : public QWidget {
    Q_OBJECT

public:
    Canvas(SceneDocument *document, Playhead *playhead, DisplayOptions *options,
           QWidget *parent = nullptr);
    ~Canvas() override;

    /// Where pictures come from that stand for a run which is not there.
    void setPreviewer(const ScenePreviewer *previewer);

    /// Device pixels per frame pixel; below 1:1 the negative of frame pixels per device pixel.
    int zoom() const { return m_mapping.zoom().number(); }
    /// "8×" or "1:4".
    QString zoomText() const;
    const ViewMapping &mapping() const { return m_mapping; }

    /// The pixel drawn under a position; none outside the frame and on the rulers.
    std::optional<QPoint> pixelAt(const QPointF &position) const;
    /// The middle of a pixel's cell.
    QPointF positionOf(const QPoint &pixel) const { return m_mapping.positionOf(pixel); }
    /// Where a point in the scene's coordinates is.
    QPointF positionOf(const LatticePoint &scenePoint) const;
    /// Where a click would place a vertex, in the scene's coordinates.
    LatticePoint placeAt(const QPointF &position) const;
    /// The vertex whose handle is under a position.
    std::optional<VertexRef> vertexAt(const QPointF &position) const;

    /// The parts of the widget: the view of the frame, and the rulers along two of its sides.
    QRectF view() const;
    QRectF columnRuler() const;
    QRectF rowRuler() const;

    bool isTruthVisible() const;
    /// What a screen reader says of the pixel or vertex in hand.
    QString spokenState() const;

    void moveViewBy(const QPoint &devicePixels);
    /// Moves time to a column of the triangle in hand, or of the one whose columns are nearest.
    void seekToColumnAt(const QPointF &position);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

public slots:
    void setZoom(int zoom);
    void zoomIn();
    void zoomOut();
    /// Shows the whole frame as large as it fits, and goes on doing so while the widget is resized.
    void fitToView();
    void editCoordinates(const pixelplumb::VertexRef &ref);

signals:
    void zoomChanged(int zoom);
    /// The point that a click would place, in the scene's coordinates; none when the pointer
    /// leaves.
    void hovered(const std::optional<pixelplumb::LatticePoint> &point);
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
    enum class ViewFit { Following, Free };
    enum class Peek { Off, Waiting, On };

    // canvas.cpp
    void connectSources();
    void followScene();
    void followVertices();
    void updateSoon();
    void followDevice();
    void setMapping(const ViewMapping &mapping);
    void zoomTo(const ViewZoom &zoom, const QPointF &anchor);
    ViewMapping fittedMapping() const;
    QPointF keyboardAnchor() const;
    const TracedScene *tracedOfFrame() const;
    void announce();

    // canvaspainting.cpp
    void paintCells(QPainter &painter);
    QImage cellsOf(const FrameBuffer &frame, const QRect &device);
    void paintRubber(FramePainter &frame, const LatticePoint &tip);
    void paintSigns(FramePainter &frame);
    void paintPending(FramePainter &frame);
    void paintNotes(FramePainter &frame);
    void paintRulers(QPainter &painter);
    const ScenePicture *shownPreview() const;
    const FrameBuffer *shownFrame() const;
    std::optional<LatticePoint> candidate();
    QString hint() const;
    QString viewNote() const;
    LatticePoint onSamples(const LatticePoint &scenePoint) const;

    // canvasoutlines.cpp
    void paintOutlines(FramePainter &frame);
    void paintHandles(FramePainter &frame);
    void paintNamesOf(int primitive, FramePainter &frame);
    std::vector<int> outlinedPrimitives();
    OutlineChoice::InHand primitivesInHand() const;
    std::optional<VertexRef> hoveredVertex();
    std::optional<SetUpRecord> setUpOf(int triangle) const;
    std::optional<int> namedPrimitive() const;

    // canvasmouse.cpp
    void beginGesture(QMouseEvent *event);
    void endGesture();
    void pressRight(const QPointF &position);
    void openVertexMenu(const VertexRef &ref, const QPointF &position);
    void toggleBreakpointAt(const QPointF &position);
    void updateCursor();
    void setHover(const std::optional<QPointF> &position);

    // canvaskeys.cpp
    bool handleArrow(QKeyEvent *event);
    bool handleEditingKey(QKeyEvent *event);
    bool handleViewKey(QKeyEvent *event);
    void placeAtPickedPixel();
    void cycleSelection(int step);
    void cancelInHand();
    void moveSelectedBy(const QPoint &steps);
    void setPeek(Peek peek);

    SceneDocument *m_document;
    Playhead *m_playhead;
    DisplayOptions *m_options;

    ViewMapping m_mapping;
    ViewFit m_fit = ViewFit::Following;
    std::unique_ptr<CanvasGesture> m_gesture;
    std::optional<QPointF> m_hover;
    /// The vertex under the pointer, if any; unknown until it is looked for.
    std::optional<std::optional<VertexRef>> m_hoveredVertex;
    /// The vertex under the last press: a double click means the one that both clicks hit.
    std::optional<VertexRef> m_pressedVertex;
    int m_wheelRest = 0; ///< eighths of a degree that are not a notch yet
    std::optional<int> m_keyDrag; ///< of the run of Ctrl+arrows under way
    Peek m_peek = Peek::Off;
    QTimer m_peekTimer;
    /// Runs while the picture of a change is expected.
    QTimer m_repaintTimer;

    OutlineChoice m_outlines;
    const ScenePreviewer *m_previewer = nullptr; ///< none: runs alone are shown
    QImage m_cells; ///< the visible cells in device pixels
    CanvasDifferences m_differences;
};

} // namespace pixelplumb
