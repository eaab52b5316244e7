// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"
#include "widgets/playhead.h"

#include <QFocusEvent>
#include <QGuiApplication>
#include <QKeyEvent>

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

void Canvas::resizeEvent(QResizeEvent *)
{
    setMapping(m_fit == ViewFit::Following ? fittedMapping() : m_mapping.keptInside(view()));
}

bool Canvas::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride)
        setPeek(Peek::Off); // Shift belongs to a shortcut
    return QWidget::event(event);
}

void Canvas::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Shift) {
        if (!event->isAutoRepeat() && QGuiApplication::mouseButtons() == Qt::NoButton && !m_gesture)
            setPeek(Peek::Waiting);
        return;
    }
    setPeek(Peek::Off);
    if (!handleArrow(event) && !handleEditingKey(event) && !handleViewKey(event))
        QWidget::keyPressEvent(event);
}

void Canvas::keyReleaseEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Shift)
        setPeek(Peek::Off);
    else if (event->key() == Qt::Key_Control && m_keyDrag) {
        m_keyDrag.reset();
        update();
    } else
        QWidget::keyReleaseEvent(event);
}

bool Canvas::handleArrow(QKeyEvent *event)
{
    const std::optional<QPoint> direction = directionOf(event->key());
    if (!direction)
        return false;
    const bool upward = m_mapping.frame().origin == FrameOrigin::BottomLeft;
    const QPoint inFrame(direction->x(), upward ? -direction->y() : direction->y());
    switch (int(modifiersOf(*event))) {
    case Qt::NoModifier:
        m_playhead->nudgePick(inFrame.x(), inFrame.y());
        return true;
    case Qt::ControlModifier:
        moveSelectedBy(inFrame);
        return true;
    case Qt::AltModifier: {
        // The view goes where the arrow points, so the picture goes the other way.
        const QSize device = m_mapping.deviceRect(view()).size() / 8;
        moveViewBy({-direction->x() * device.width(), -direction->y() * device.height()});
        return true;
    }
    default:
        return false;
    }
}

bool Canvas::handleEditingKey(QKeyEvent *event)
{
    const std::optional<VertexRef> selected = m_document->selectedVertex();
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
            emit colourRequested(*selected);
        else
            placeAtPickedPixel();
        return true;
    case Qt::Key_Insert:
        placeAtPickedPixel();
        return true;
    case Qt::Key_C:
        if (selected)
            emit colourRequested(*selected);
        return selected.has_value();
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        if (selected)
            m_document->deleteVertex(*selected);
        return selected.has_value();
    case Qt::Key_Escape:
        cancelInHand();
        return true;
    default:
        return false;
    }
}

bool Canvas::handleViewKey(QKeyEvent *event)
{
    if (modifiersOf(*event) & ~Qt::ShiftModifier)
        return false;
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal: // where + needs Shift
        zoomIn();
        return true;
    case Qt::Key_Minus:
        zoomOut();
        return true;
    case Qt::Key_0:
        fitToView();
        return true;
    default:
        return false;
    }
}

void Canvas::placeAtPickedPixel()
{
    const std::optional<QPoint> pixel = m_playhead->pickedPixel();
    if (!pixel)
        return;
    const Lattice offset = sampleOffset(m_mapping.frame());
    const LatticePoint sample = latticePixel(pixel->x(), pixel->y());
    m_document->placeVertex({sample.x + offset, sample.y + offset});
}

void Canvas::cycleSelection(int step)
{
    const std::vector<VertexRef> vertices = m_document->vertices();
    if (vertices.empty())
        return;
    const auto count = int(vertices.size());
    const std::optional<VertexRef> selected = m_document->selectedVertex();
    const auto found = selected ? std::ranges::find(vertices, *selected) : vertices.end();
    int next = step > 0 ? 0 : count - 1;
    if (found != vertices.end())
        next = (int(found - vertices.begin()) + step + count) % count;
    m_document->selectVertex(vertices[std::size_t(next)]);
}

void Canvas::cancelInHand()
{
    if (m_gesture) {
        m_gesture->cancel();
        endGesture();
    } else if (!m_document->pendingVertices().empty()) {
        m_document->discardPending();
    } else {
        m_document->selectVertex(std::nullopt);
    }
}

void Canvas::moveSelectedBy(const QPoint &steps)
{
    const std::optional<VertexRef> ref = m_document->selectedVertex();
    if (!ref)
        return;
    if (!m_keyDrag)
        m_keyDrag = m_document->newDrag();
    const Lattice step = stepOf(m_document->snap());
    const LatticePoint position = m_document->vertexAt(*ref)->position;
    m_document->moveVertex(*ref, {position.x + steps.x() * step, position.y + steps.y() * step},
                           *m_keyDrag);
}

void Canvas::setPeek(Peek peek)
{
    if (peek == m_peek)
        return;
    m_peek = peek;
    if (peek == Peek::Waiting)
        m_peekTimer.start();
    else
        m_peekTimer.stop();
    update();
}

void Canvas::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void Canvas::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    setPeek(Peek::Off);
    m_keyDrag.reset();
    update();
}

} // namespace pixelplumb
