// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvasgesture.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

#include <memory>

namespace pixelplumb {

class CanvasView;
class Playhead;
struct CanvasSources;

/// What a left click does: it places and moves vertices, or it picks pixels and leaves the scene
/// alone. All other mouse actions are the same with both tools.
enum class CanvasTool { Draw, Inspect };

/// Mouse input on the canvas: hovering, and gestures that a press begins and a release ends.
class CanvasMouse {
public:
    CanvasMouse(Canvas &canvas, CanvasView &view, const CanvasSources &sources);

    void press(QMouseEvent *event);
    void move(const QPointF &position);
    void release(QMouseEvent *event);
    void doubleClick(QMouseEvent *event);
    void turn(QWheelEvent *event);
    /// None: the pointer has left.
    void hoverAt(const std::optional<QPointF> &position);

    CanvasTool tool() const { return m_tool; }
    /// A gesture in progress continues.
    void setTool(CanvasTool tool) { m_tool = tool; }

    const std::optional<QPointF> &hover() const { return m_hover; }
    /// The vertex under the pointer, looked up once per pointer position: a large scene has
    /// millions of vertices.
    std::optional<VertexRef> hoveredVertex() const;
    /// To be called when the scene or the view has changed under the pointer.
    void forgetHovered() { m_hoveredVertex.reset(); }
    /// Corners of the affine map's image: the one under the pointer, and the one last pressed or
    /// chosen by a key.
    std::optional<std::size_t> hoveredCorner() const;
    std::optional<std::size_t> chosenCorner() const { return m_chosenCorner; }
    void chooseCorner(const std::optional<std::size_t> &corner);
    /// The vertex that a click would place, in the scene's coordinates.
    std::optional<LatticePoint> candidate() const;
    Qt::CursorShape cursor() const;

    bool isPressed() const { return m_gesture != nullptr; }
    bool isMovingVertex() const;
    /// Leaves everything as it was before the press.
    void cancelGesture();

    void openVertexMenu(const VertexRef &ref, const QPointF &position);

private:
    void begin(QMouseEvent *event);
    void end();
    std::unique_ptr<CanvasGesture> drawingGesture(const QPointF &position);
    void pressRight(const QPointF &position);
    void toggleBreakpointAt(const QPointF &position);

    bool isHandleUnderPointer() const;

    Canvas &m_canvas;
    CanvasView &m_view;
    const CanvasSources &m_sources;
    SceneDocument &m_document;
    Playhead &m_playhead;
    CanvasTool m_tool = CanvasTool::Draw;
    std::unique_ptr<CanvasGesture> m_gesture;
    std::optional<QPointF> m_hover;
    /// The vertex under the pointer, if any; unset until it is looked up.
    mutable std::optional<std::optional<VertexRef>> m_hoveredVertex;
    /// The vertex under the last press: a double click needs both clicks on the same one.
    std::optional<VertexRef> m_pressedVertex;
    std::optional<std::size_t> m_chosenCorner;
    int m_wheelRest = 0; ///< eighths of a degree short of a notch
};

/// The menu of a vertex.
class CanvasMenu : public QMenu {
    Q_OBJECT

public:
    CanvasMenu(SceneDocument *document, const VertexRef &ref, QWidget *parent = nullptr);

signals:
    void colourRequested(const pixelplumb::VertexRef &ref);
    void coordinatesRequested(const pixelplumb::VertexRef &ref);

private:
    void askForText(SceneDocument *document, const VertexRef &ref);
};

} // namespace pixelplumb
