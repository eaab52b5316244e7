// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/viewfollower.h"

#include "widgets/canvas/canvasmouse.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/model/playhead.h"

#include <utility>

namespace pixelplumb {

ViewFollower::ViewFollower(CanvasView &view, const CanvasMouse &mouse, const Playhead *playhead)
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
