// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvaslayers.h"

#include "core/layers/layer.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/canvas/imagehandles.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/layersurface.h"
#include "widgets/model/playhead.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The pixels whose cells meet the area, inside the frame or not.
SampleBox pixelsIn(const QRectF &area, const ViewMapping &mapping)
{
    const auto [left, right]
        = std::minmax({mapping.columnAt(area.topLeft()), mapping.columnAt(area.bottomRight())});
    const auto [low, high]
        = std::minmax({mapping.rowAt(area.topLeft()), mapping.rowAt(area.bottomRight())});
    return {left, right + 1, low, high + 1};
}

} // namespace

void CanvasLayers::addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view)
{
    if (sources.options->layers().isEmpty() || !runInView(sources)) {
        *this = {};
        return;
    }
    const Moment moment = {sources.playhead->sharedTraced(),
                           sources.playhead->position(),
                           sources.options->layers(),
                           view.mapping(),
                           view.area(),
                           sources.playhead->pickedPixel(),
                           sources.options->affineImage(),
                           sources.playhead->ahead()};
    if (moment != m_moment) {
        m_moment = moment;
        m_drawing = drawingOf(moment.layers,
                              {moment.traced.get(), moment.position,
                               pixelsIn(moment.area, moment.mapping), cellSideOf(moment.mapping),
                               std::nullopt, moment.picked, moment.image, moment.ahead});
    }
    scene.layers = m_drawing;
}

} // namespace pixelplumb
