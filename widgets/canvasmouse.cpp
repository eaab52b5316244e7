// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas.h"
#include "widgets/canvasmenu.h"
#include "widgets/playhead.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr int eighthsPerNotch = 120; // of a degree; QWheelEvent::angleDelta

/// The trace's column that stands at x, of the preferred primitive, else of the one with the
/// nearest.
std::optional<std::size_t> columnNear(const ScanTrace &trace, std::size_t preferred, std::int64_t x)
{
    std::optional<std::size_t> nearest;
    std::int64_t leastDistance = 0;
    for (std::size_t i = 0; i < trace.primitiveCount(); ++i) {
        const std::size_t primitive = (preferred + i) % trace.primitiveCount();
        for (std::size_t span = trace.firstSpanOf(primitive); span < trace.endSpanOf(primitive);
             ++span) {
            const SpanPlace &place = trace.placeOf(span);
            if (place.axis != SpanAxis::Column)
                continue;
            const std::int64_t distance = std::abs(place.coordinate - x);
            if (!nearest || distance < leastDistance) {
                nearest = span;
                leastDistance = distance;
            }
        }
    }
    return nearest;
}

} // namespace

void Canvas::seekToColumnAt(const QPointF &position)
{
    const TracedScene *traced = m_playhead->traced();
    if (!traced)
        return;
    const std::optional<TraceStep> step = m_playhead->stepInHand();
    const std::optional<std::size_t> column
        = columnNear(*traced->trace, step ? step->primitive : 0, m_mapping.columnAt(position));
    if (column)
        m_playhead->seekToSpan(*column);
}

void Canvas::mousePressEvent(QMouseEvent *event)
{
    setPeek(Peek::Off);
    setHover(event->position());
    if (m_gesture)
        return; // a second button while the first does something
    if (event->button() == Qt::RightButton) {
        pressRight(event->position());
        return;
    }
    m_pressedVertex = vertexAt(event->position());
    beginGesture(event);
}

void Canvas::beginGesture(QMouseEvent *event)
{
    const QPointF position = event->position();
    const bool left = event->button() == Qt::LeftButton;
    const bool moveView = event->button() == Qt::MiddleButton
        || (left && event->modifiers().testFlag(Qt::ControlModifier));
    if (moveView) {
        m_gesture = std::make_unique<MoveViewGesture>(*this, position);
    } else if (left && columnRuler().contains(position)) {
        m_gesture = std::make_unique<SeekColumnGesture>(*this);
        m_gesture->moveTo(position);
    } else if (left && m_pressedVertex == VertexRef{VertexRef::pending, 0}
               && m_document->canClosePending()) {
        m_document->closePending();
    } else if (left && m_pressedVertex) {
        m_gesture
            = std::make_unique<MoveVertexGesture>(*this, *m_document, *m_pressedVertex, position);
    } else if (left && view().contains(position)) {
        m_document->selectVertex(std::nullopt);
        m_gesture = std::make_unique<PlaceVertexGesture>(*this, *m_document);
    }
    updateCursor();
}

void Canvas::mouseMoveEvent(QMouseEvent *event)
{
    if (m_gesture)
        m_gesture->moveTo(event->position());
    setHover(event->position());
}

void Canvas::mouseReleaseEvent(QMouseEvent *event)
{
    const bool ends = m_gesture && event->button() != Qt::RightButton;
    setHover(event->position());
    if (!ends)
        return;
    m_gesture->releaseAt(event->position());
    endGesture();
}

void Canvas::endGesture()
{
    m_gesture.reset();
    updateCursor();
    update();
}

void Canvas::mouseDoubleClickEvent(QMouseEvent *event)
{
    const QPointF position = event->position();
    const std::optional<VertexRef> ref = vertexAt(position);
    if (event->button() == Qt::LeftButton && columnRuler().contains(position)) {
        toggleBreakpointAt(position);
    } else if (event->button() == Qt::LeftButton && ref) {
        if (ref == m_pressedVertex) // else the first click placed it
            emit colourRequested(*ref);
    } else {
        mousePressEvent(event); // two quick clicks at two places
    }
}

void Canvas::pressRight(const QPointF &position)
{
    if (columnRuler().contains(position)) {
        toggleBreakpointAt(position);
    } else if (const std::optional<VertexRef> ref = vertexAt(position)) {
        m_document->selectVertex(ref);
        openVertexMenu(*ref, position);
    } else if (const std::optional<QPoint> pixel = pixelAt(position)) {
        m_playhead->pick(*pixel);
    }
}

void Canvas::openVertexMenu(const VertexRef &ref, const QPointF &position)
{
    auto *menu = new CanvasMenu(m_document, ref, this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu, &CanvasMenu::colourRequested, this, &Canvas::colourRequested);
    connect(menu, &CanvasMenu::coordinatesRequested, this, &Canvas::editCoordinates);
    menu->popup(mapToGlobal(position.toPoint()));
}

void Canvas::contextMenuEvent(QContextMenuEvent *event)
{
    // A right press has been dealt with already; here the menu key alone asks.
    if (event->reason() != QContextMenuEvent::Keyboard)
        return;
    if (const std::optional<VertexRef> ref = m_document->selectedVertex())
        openVertexMenu(*ref, positionOf(m_document->vertexAt(*ref)->position));
}

void Canvas::toggleBreakpointAt(const QPointF &position)
{
    m_playhead->toggleSpanBreakpoint({SpanAxis::Column, m_mapping.columnAt(position), 0});
}

void Canvas::wheelEvent(QWheelEvent *event)
{
    event->accept();
    m_wheelRest += event->angleDelta().y();
    const int notches = m_wheelRest / eighthsPerNotch;
    m_wheelRest -= notches * eighthsPerNotch;
    for (int notch = 0; notch < std::abs(notches); ++notch) {
        const ViewZoom &zoom = m_mapping.zoom();
        zoomTo(notches > 0 ? zoom.nextLarger() : zoom.nextSmaller(), event->position());
    }
    setHover(event->position());
}

void Canvas::leaveEvent(QEvent *) { setHover(std::nullopt); }

void Canvas::setHover(const std::optional<QPointF> &position)
{
    m_hover = position;
    m_hoveredVertex.reset();
    const bool inView = position && view().contains(*position);
    emit hovered(inView ? std::optional(placeAt(*position)) : std::nullopt);
    updateCursor();
    if (!m_repaintTimer.isActive())
        update();
}

void Canvas::updateCursor()
{
    if (m_gesture)
        setCursor(m_gesture->cursor());
    else if (m_hover && columnRuler().contains(*m_hover))
        setCursor(Qt::PointingHandCursor);
    else if (hoveredVertex())
        setCursor(Qt::SizeAllCursor);
    else if (m_hover && view().contains(*m_hover))
        setCursor(Qt::CrossCursor);
    else
        setCursor(Qt::ArrowCursor);
}

} // namespace pixelplumb
