// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvaskeys.h"

#include "widgets/canvas/canvas.h"
#include "widgets/canvas/canvasmouse.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/displayoptions.h"
#include "widgets/model/playhead.h"

#include <QtWidgets>

#include <algorithm>

namespace pixelplumb {

namespace {

/// The direction of an arrow key on the screen, y downward; none for other keys.
std::optional<QPoint> directionOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return QPoint(-1, 0);
    case Qt::Key_Right:
        return QPoint(1, 0);
    case Qt::Key_Up:
        return QPoint(0, -1);
    case Qt::Key_Down:
        return QPoint(0, 1);
    default:
        return std::nullopt;
    }
}

Qt::KeyboardModifiers modifiersOf(const QKeyEvent &event)
{
    return event.modifiers() & ~Qt::KeypadModifier;
}

} // namespace

CanvasKeys::CanvasKeys(Canvas &canvas, CanvasView &view, CanvasMouse &mouse,
                       const CanvasSources &sources)
    : m_canvas(canvas)
    , m_view(view)
    , m_mouse(mouse)
    , m_sources(sources)
    , m_document(*sources.document)
    , m_playhead(*sources.playhead)
{
    m_peekTimer.setSingleShot(true);
    m_peekTimer.setInterval(peekDelay);
    QObject::connect(&m_peekTimer, &QTimer::timeout, &canvas, [this] { setPeek(Peek::On); });
}

bool CanvasKeys::press(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Shift) {
        if (!event->isAutoRepeat() && QGuiApplication::mouseButtons() == Qt::NoButton
            && !m_mouse.isPressed())
            setPeek(Peek::Waiting);
        return true;
    }
    setPeek(Peek::Off);
    return handleArrow(event) || handleEditingKey(event) || handleViewKey(event);
}

bool CanvasKeys::release(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Shift) {
        setPeek(Peek::Off);
        return true;
    }
    if (event->key() != Qt::Key_Control || !m_drag)
        return false;
    m_drag.reset();
    m_canvas.update();
    return true;
}

std::optional<LatticePoint> CanvasKeys::candidate() const
{
    const std::optional<QPoint> picked = m_playhead.pickedPixel();
    if (m_mouse.hover() || !m_canvas.hasFocus() || !picked || m_document.pendingVertices().empty())
        return std::nullopt;
    return m_view.fromSamples(latticePixel(picked->x(), picked->y()));
}

bool CanvasKeys::handleArrow(QKeyEvent *event)
{
    const std::optional<QPoint> direction = directionOf(event->key());
    if (!direction)
        return false;
    const bool upward = m_view.mapping().frame().origin == FrameOrigin::BottomLeft;
    const QPoint inFrame(direction->x(), upward ? -direction->y() : direction->y());
    switch (int(modifiersOf(*event))) {
    case Qt::NoModifier:
        m_mouse.hoverAt(std::nullopt); // the readout describes the picked pixel
        m_playhead.nudgePick(inFrame.x(), inFrame.y());
        return true;
    case Qt::ControlModifier:
        moveSelectedBy(inFrame);
        return true;
    case Qt::ShiftModifier: {
        // The view moves in the arrow's direction, so the picture moves the other way.
        const QSize device = m_view.mapping().deviceRect(m_view.area()).size() / 8;
        m_view.moveBy({-direction->x() * device.width(), -direction->y() * device.height()});
        return true;
    }
    default:
        return false;
    }
}

bool CanvasKeys::handleEditingKey(QKeyEvent *event)
{
    const std::optional<VertexRef> selected = m_document.selectedVertex();
    // Some keyboards need Shift or AltGr for the brackets.
    if (event->key() == Qt::Key_BracketLeft || event->key() == Qt::Key_BracketRight) {
        cycleSelection(event->key() == Qt::Key_BracketLeft ? -1 : 1);
        return true;
    }
    if (modifiersOf(*event) != Qt::NoModifier)
        return false;
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (selected)
            emit m_canvas.colourRequested(*selected);
        else
            placeAtPickedPixel();
        return true;
    case Qt::Key_Insert:
        placeAtPickedPixel();
        return true;
    case Qt::Key_C:
        if (selected)
            emit m_canvas.colourRequested(*selected);
        return selected.has_value();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (selected)
            m_document.deleteVertex(*selected);
        return selected.has_value();
    case Qt::Key_Escape:
        cancelCurrent();
        return true;
    default:
        return false;
    }
}

bool CanvasKeys::handleViewKey(QKeyEvent *event)
{
    if (modifiersOf(*event) & ~Qt::ShiftModifier)
        return false;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // where + needs Shift
        m_canvas.zoomIn();
        return true;
    case Qt::Key_Minus:
        m_canvas.zoomOut();
        return true;
    case Qt::Key_0:
        m_canvas.fitToView();
        return true;
    default:
        return false;
    }
}

void CanvasKeys::placeAtPickedPixel()
{
    const std::optional<QPoint> pixel = m_playhead.pickedPixel();
    if (!pixel)
        return;
    m_document.placeVertex(
        m_document.fromCurrentFrame(m_view.fromSamples(latticePixel(pixel->x(), pixel->y()))));
}

void CanvasKeys::cycleSelection(int step)
{
    const std::vector<VertexRef> vertices = m_document.vertices();
    const auto vertexCount = int(vertices.size());
    const int count = vertexCount + (imageInView(m_sources) ? 3 : 0);
    if (count == 0)
        return;
    const std::optional<VertexRef> selected = m_document.selectedVertex();
    const auto found = selected ? std::ranges::find(vertices, *selected) : vertices.end();
    int next = step > 0 ? 0 : count - 1;
    if (found != vertices.end())
        next = (int(found - vertices.begin()) + step + count) % count;
    else if (const std::optional<std::size_t> corner = m_mouse.chosenCorner();
             corner && count > vertexCount)
        next = (vertexCount + int(*corner) + step + count) % count;
    if (next < vertexCount)
        m_document.selectVertex(vertices[std::size_t(next)]);
    else
        m_mouse.chooseCorner(std::size_t(next - vertexCount));
}

void CanvasKeys::cancelCurrent()
{
    if (m_mouse.isPressed()) {
        m_mouse.cancelGesture();
    } else if (!m_document.pendingVertices().empty()) {
        m_document.discardPending();
    } else {
        m_document.selectVertex(std::nullopt);
        m_mouse.chooseCorner(std::nullopt);
    }
}

void CanvasKeys::moveSelectedBy(const QPoint &steps)
{
    const Lattice step = stepOf(m_document.snap());
    const std::optional<VertexRef> ref = m_document.selectedVertex();
    if (!ref) {
        moveChosenCornerBy({steps.x() * step, steps.y() * step});
        return;
    }
    if (!m_drag)
        m_drag = m_document.newDrag();
    const LatticePoint position = m_document.vertexAt(*ref)->position;
    m_document.moveVertex(*ref, {position.x + steps.x() * step, position.y + steps.y() * step},
                          *m_drag);
}

void CanvasKeys::moveChosenCornerBy(const LatticePoint &way)
{
    const std::optional<std::size_t> corner = m_mouse.chosenCorner();
    const std::optional<AffineImage> image = corner ? imageInView(m_sources) : std::nullopt;
    if (!image)
        return;
    if (!m_drag)
        m_drag = m_document.newDrag();
    const LatticePoint place = image->corners[*corner];
    moveImageCorner(m_sources, *image, *corner, {place.x + way.x, place.y + way.y}, *m_drag);
}

void CanvasKeys::setPeek(Peek peek)
{
    if (peek == m_peek)
        return;
    m_peek = peek;
    if (peek == Peek::Waiting)
        m_peekTimer.start();
    else
        m_peekTimer.stop();
    m_canvas.update();
}

} // namespace pixelplumb
