// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvasview.h"

#include "widgets/canvas/canvasmouse.h"
#include "widgets/canvas/ruler.h"
#include "widgets/model/playhead.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pixelplumb {

namespace {

// Logical pixels.
constexpr double fitMargin = 12; ///< for handles of vertices on the frame's border

} // namespace

QPointF fractionOf(const QWidget &widget)
{
    const QPointF corner
        = QPointF(widget.mapTo(widget.window(), QPoint(0, 0))) * widget.devicePixelRatioF();
    return {corner.x() - std::floor(corner.x()), corner.y() - std::floor(corner.y())};
}

CanvasView::CanvasView(const SceneDocument *document, QWidget *canvas)
    : QObject(canvas)
    , m_document(document)
    , m_canvas(canvas)
    , m_mapping(fitted())
{
}

QRect CanvasView::bounds() const { return m_canvas->rect(); }

QRectF CanvasView::area() const
{
    const QFontMetricsF metrics(m_canvas->font());
    const FrameSpec &frame = m_document->scene().frame;
    const double left = rowRulerWidth(metrics, frame);
    const double ruler = columnRulerHeight(metrics);
    const bool below = frame.origin == FrameOrigin::BottomLeft;
    return {left, below ? 0 : ruler, std::max(1.0, m_canvas->width() - left),
            std::max(1.0, m_canvas->height() - ruler)};
}

QRectF CanvasView::columnRuler() const
{
    const QRectF frame = area();
    const double thickness = m_canvas->height() - frame.height();
    return {frame.left(), frame.top() > 0 ? 0 : frame.bottom(), frame.width(), thickness};
}

QRectF CanvasView::rowRuler() const
{
    const QRectF frame = area();
    return {0, frame.top(), frame.left(), frame.height()};
}

std::optional<QPoint> CanvasView::pixelAt(const QPointF &position) const
{
    return area().contains(position) ? m_mapping.pixelAt(position) : std::nullopt;
}

QPointF CanvasView::positionOf(const LatticePoint &scenePoint) const
{
    return m_mapping.positionOf(onSamples(scenePoint));
}

LatticePoint CanvasView::onSamples(const LatticePoint &scenePoint) const
{
    const Lattice offset = sampleOffset(m_mapping.frame());
    return {scenePoint.x - offset, scenePoint.y - offset};
}

LatticePoint CanvasView::fromSamples(const LatticePoint &samplePoint) const
{
    const Lattice offset = sampleOffset(m_mapping.frame());
    return {samplePoint.x + offset, samplePoint.y + offset};
}

LatticePoint CanvasView::placeAt(const QPointF &position) const
{
    // The pixel under the pointer, even at the very edge of its cell.
    if (m_document->snap() == Snap::Pixel && m_mapping.frame().pixelCentre == PixelCentre::Integer)
        return latticePixel(m_mapping.columnAt(position), m_mapping.rowAt(position));
    return m_document->snapped(fromSamples(m_mapping.latticeAt(position)));
}

void CanvasView::fit()
{
    m_fit = Fit::Following;
    setMapping(fitted());
}

void CanvasView::zoomTo(const ViewZoom &zoom, const QPointF &anchor)
{
    // A frame that fits is never shown below 1:1.
    const int least = std::min(1, fitted().zoom().number());
    const ViewZoom allowed = ViewZoom::fromNumber(std::max(zoom.number(), least));
    m_fit = Fit::Free;
    setMapping(m_mapping.zoomedAt(anchor, allowed).keptInside(area()));
}

void CanvasView::moveBy(const QPoint &devicePixels)
{
    m_fit = Fit::Free;
    setMapping(m_mapping.movedBy(devicePixels).keptInside(area()));
}

void CanvasView::reveal(const QPoint &pixel)
{
    const QRectF view = area();
    const QRectF cell = m_mapping.cellOf(pixel);
    const QPointF way = (view.center() - cell.center()) * m_mapping.devicePixelRatio();
    const bool isSeenAcross = cell.left() >= view.left() && cell.right() <= view.right();
    const bool isSeenUp = cell.top() >= view.top() && cell.bottom() <= view.bottom();
    const QPoint move(isSeenAcross ? 0 : qRound(way.x()), isSeenUp ? 0 : qRound(way.y()));
    if (!move.isNull())
        moveBy(move);
}

void CanvasView::followFrame()
{
    const FrameSpec &frame = m_document->scene().frame;
    if (frame == m_mapping.frame())
        return;
    // A place in a frame of another size is meaningless in this one.
    if (frame.width != m_mapping.frame().width || frame.height != m_mapping.frame().height)
        m_fit = Fit::Following;
    const ViewMapping kept(frame, m_mapping.zoom(), m_mapping.origin(),
                           m_mapping.devicePixelRatio(), m_mapping.fraction());
    setMapping(m_fit == Fit::Following ? fitted() : kept.keptInside(area()));
}

void CanvasView::followSize()
{
    setMapping(m_fit == Fit::Following ? fitted() : m_mapping.keptInside(area()));
}

void CanvasView::followDevice()
{
    const double ratio = m_canvas->devicePixelRatioF();
    const QPointF fraction = fractionOf(*m_canvas);
    if (ratio == m_mapping.devicePixelRatio() && fraction == m_mapping.fraction())
        return;
    if (m_fit == Fit::Following) {
        setMapping(fitted());
        return;
    }
    const QPointF corner = m_mapping.positionOfDevice(m_mapping.origin());
    const ViewMapping moved(m_mapping.frame(), m_mapping.zoom(), {}, ratio, fraction);
    setMapping(moved.movedBy(moved.deviceAt(corner)).keptInside(area()));
}

ViewMapping CanvasView::fitted() const
{
    const QRectF room = area().adjusted(fitMargin, fitMargin, -fitMargin, -fitMargin);
    return ViewMapping::fitted(m_document->scene().frame, room, m_canvas->devicePixelRatioF(),
                               fractionOf(*m_canvas));
}

void CanvasView::setMapping(const ViewMapping &mapping)
{
    const bool zoomed = mapping.zoom() != m_mapping.zoom();
    m_mapping = mapping;
    emit changed();
    if (zoomed)
        emit zoomChanged(m_mapping.zoom().number());
}

ViewFollower::ViewFollower(CanvasView &view, CanvasMouse &mouse, const Playhead *playhead)
    : m_view(view)
    , m_mouse(mouse)
    , m_playhead(playhead)
{
    connect(playhead, &Playhead::tracedChanged, this, &ViewFollower::follow);
    connect(playhead, &Playhead::positionChanged, this, &ViewFollower::follow);
    connect(playhead, &Playhead::pickedPixelChanged, this, &ViewFollower::follow);
}

void ViewFollower::follow()
{
    const Moment now{m_playhead->traced(), m_playhead->position(), m_playhead->pickedPixel()};
    const Moment before = std::exchange(m_moment, now);
    if (now == before || now.traced != before.traced || m_mouse.isPressed())
        return;
    if (now.position != before.position)
        m_mouse.hoverAt(
            std::nullopt); // the person looks at the step, not where the pointer was left
    if (const std::optional<QPoint> pixel = pixelSince(before))
        m_view.reveal(*pixel);
}

/// The pixel to reveal: the step's, which is picked. For a span without pixels, and for one whose
/// pixel is to be predicted, only its column or row is known.
std::optional<QPoint> ViewFollower::pixelSince(const Moment &before) const
{
    const std::optional<SpanPlace> place = m_playhead->currentPlace();
    if (m_moment.picked != before.picked || !place)
        return m_moment.picked;
    std::optional<QPoint> pixel = m_moment.picked;
    if (!pixel)
        pixel = m_view.mapping().pixelAt(m_view.area().center());
    if (pixel && place->axis == SpanAxis::Column)
        pixel->setX(int(place->coordinate));
    if (pixel && place->axis == SpanAxis::Row)
        pixel->setY(int(place->coordinate));
    return pixel;
}

} // namespace pixelplumb
