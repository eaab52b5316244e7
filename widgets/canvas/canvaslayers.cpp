// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/canvas/canvaslayers.h"

#include "core/layers/layer.h"
#include "widgets/canvas/canvasoutlines.h"
#include "widgets/canvas/canvasview.h"
#include "widgets/look/displayoptions.h"
#include "widgets/look/layersurface.h"
#include "widgets/model/playhead.h"
#include "widgets/model/scenepreviewer.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The pixels whose cells meet the area, in the frame or not.
SampleBox pixelsIn(const QRectF &area, const ViewMapping &mapping)
{
    const auto [left, right]
        = std::minmax({mapping.columnAt(area.topLeft()), mapping.columnAt(area.bottomRight())});
    const auto [low, high]
        = std::minmax({mapping.rowAt(area.topLeft()), mapping.rowAt(area.bottomRight())});
    return {left, right + 1, low, high + 1};
}

bool isRunOfScene(const CanvasSources &sources)
{
    const bool isAhead = sources.previewer && sources.previewer->isAheadOfTrace();
    return !isAhead && !sources.options->isTruthShown()
        && tracedOfFrame(*sources.document, *sources.playhead);
}

} // namespace

void CanvasLayers::addTo(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view)
{
    if (sources.options->layers().isEmpty() || !isRunOfScene(sources)) {
        *this = {};
        return;
    }
    const Moment moment = {sources.playhead->sharedTraced(), sources.playhead->position(),
                           sources.options->layers(), view.mapping(), view.area()};
    if (moment != m_moment) {
        m_moment = moment;
        m_drawing = drawingOf(moment.layers,
                              {moment.traced.get(), moment.position,
                               pixelsIn(moment.area, moment.mapping), cellSideOf(moment.mapping),
                               std::nullopt});
    }
    scene.layers = m_drawing;
    if (!m_drawing.notes.isEmpty())
        scene.notes.push_back(
            {m_drawing.notes.join(u'\n'), moment.area.bottomLeft(), NoteSide::AboveRight});
}

} // namespace pixelplumb
