// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasgesture.h"

#include "widgets/canvas/canvasview.h"
#include "widgets/model/playhead.h"

#include <cstdlib>

namespace pixelplumb {

namespace {

/// The trace's column at x, of the preferred primitive, else of the primitive with the nearest
/// column.
std::optional<std::size_t> spanNear(const ScanTrace &trace, std::size_t preferred, std::int64_t x)
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

void PlaceVertexGesture::releaseAt(const QPointF &position)
{
    if (m_view.area().contains(position))
        m_document.placeVertex(m_document.fromCurrentFrame(m_view.placeAt(position)));
}

void PickPixelGesture::moveTo(const QPointF &position)
{
    if (const std::optional<QPoint> pixel = m_view.pixelAt(position))
        m_playhead.pick(*pixel);
}

MoveViewGesture::MoveViewGesture(CanvasView &view, const QPointF &press)
    : m_view(view)
    , m_device(view.mapping().deviceAt(press))
{
}

void MoveViewGesture::moveTo(const QPointF &position)
{
    const QPoint device = m_view.mapping().deviceAt(position);
    m_view.moveBy(device - m_device);
    m_device = device;
}

void SeekColumnGesture::moveTo(const QPointF &position)
{
    const TracedScene *traced = m_playhead.traced();
    if (!traced)
        return;
    const std::optional<TraceStep> step = m_playhead.currentStep();
    const std::optional<std::size_t> span
        = spanNear(*traced->trace, step ? step->primitive : 0, m_view.mapping().columnAt(position));
    if (span)
        m_playhead.seekToSpan(*span);
}

} // namespace pixelplumb
