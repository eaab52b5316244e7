// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvasgesture.h"

#include "widgets/canvas.h"

namespace pixelplumb {

namespace {

/// Logical pixels that a hand trembles in a click.
constexpr double tremble = 3;

} // namespace

void PlaceVertexGesture::releaseAt(const QPointF &position)
{
    if (m_canvas.view().contains(position))
        m_document.placeVertex(m_canvas.placeAt(position));
}

MoveVertexGesture::MoveVertexGesture(Canvas &canvas, SceneDocument &document, const VertexRef &ref,
                                     const QPointF &press)
    : m_canvas(canvas)
    , m_document(document)
    , m_ref(ref)
    , m_press(press)
    , m_start(document.vertexAt(ref)->position)
    , m_drag(document.newDrag())
{
    document.selectVertex(ref);
}

void MoveVertexGesture::moveTo(const QPointF &position)
{
    m_moving = m_moving || (position - m_press).manhattanLength() > tremble;
    if (!m_moving)
        return;
    const LatticePoint pressed = m_canvas.mapping().latticeAt(m_press);
    const LatticePoint now = m_canvas.mapping().latticeAt(position);
    const LatticePoint target
        = m_document.snapped({m_start.x + now.x - pressed.x, m_start.y + now.y - pressed.y});
    m_document.moveVertex(m_ref, target, m_drag);
}

void MoveVertexGesture::cancel() { m_document.moveVertex(m_ref, m_start, m_drag); }

MoveViewGesture::MoveViewGesture(Canvas &canvas, const QPointF &press)
    : m_canvas(canvas)
    , m_device(canvas.mapping().deviceAt(press))
{
}

void MoveViewGesture::moveTo(const QPointF &position)
{
    const QPoint device = m_canvas.mapping().deviceAt(position);
    m_canvas.moveViewBy(device - m_device);
    m_device = device;
}

void SeekColumnGesture::moveTo(const QPointF &position) { m_canvas.seekToColumnAt(position); }

} // namespace pixelplumb
