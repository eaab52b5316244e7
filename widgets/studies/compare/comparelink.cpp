// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/studies/compare/comparelink.h"

namespace pixelplumb {

namespace {

constexpr double fitMargin = 4; ///< logical pixels around a fitted frame
constexpr int lookZoom = 12; ///< device pixels a frame pixel

} // namespace

void CompareLink::setFrame(const FrameSpec &frame)
{
    if (frame == m_frame)
        return;
    m_frame = frame;
    m_place = Place::Fitted;
    emit changed();
}

ViewMapping CompareLink::mappingFor(const QSizeF &size, double devicePixelRatio,
                                    const QPointF &fraction) const
{
    const QRectF view(QPointF(), size);
    const ViewMapping fitted
        = ViewMapping::fitted(m_frame, view.adjusted(fitMargin, fitMargin, -fitMargin, -fitMargin),
                              devicePixelRatio, fraction);
    const bool hasRoom = fitted.zoom().number() >= m_zoom.number();
    if (m_place == Place::Fitted || (m_place == Place::LookedAt && hasRoom))
        return fitted;
    const ViewMapping mapping(m_frame, m_zoom, {}, devicePixelRatio, fraction);
    const QPointF centre = mapping.positionOf(m_centre.x(), m_centre.y());
    return mapping.movedBy(mapping.deviceAt(view.center()) - mapping.deviceAt(centre));
}

void CompareLink::fit()
{
    m_place = Place::Fitted;
    emit changed();
}

void CompareLink::zoomIn(const ViewMapping &from, const QRectF &view, const QPointF &anchor)
{
    take(from.zoomedAt(anchor, from.zoom().nextLarger()), view);
}

void CompareLink::zoomOut(const ViewMapping &from, const QRectF &view, const QPointF &anchor)
{
    const ViewMapping whole
        = ViewMapping::fitted(m_frame, view, from.devicePixelRatio(), from.fraction());
    if (from.zoom().number() <= whole.zoom().number())
        return fit();
    take(from.zoomedAt(anchor, from.zoom().nextSmaller()).keptInside(view), view);
}

void CompareLink::moveBy(const ViewMapping &from, const QRectF &view, const QPoint &devicePixels)
{
    take(from.movedBy(devicePixels).keptInside(view), view);
}

void CompareLink::lookAt(const QPoint &pixel)
{
    m_place = Place::LookedAt;
    m_zoom = ViewZoom::fromNumber(std::max(lookZoom, m_zoom.number()));
    m_centre = pixel;
    emit changed();
}

void CompareLink::take(const ViewMapping &mapping, const QRectF &view)
{
    const LatticePoint centre = mapping.latticeAt(view.center());
    m_place = Place::Free;
    m_zoom = mapping.zoom();
    m_centre = QPointF(double(centre.x), double(centre.y)) / unitsPerPixel;
    emit changed();
}

} // namespace pixelplumb
