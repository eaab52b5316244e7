// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvasscene.h"

namespace pixelplumb {

/// A press this near to a handle's centre hits it, logical pixels.
inline constexpr double handleHitRadius = 8;

/// Outlines, handles and names of the document's primitives. They come straight from the document,
/// so that they never lag behind the pointer.
void addOutlines(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view,
                 const OutlineChoice &choice, const CanvasHand &hand);

/// The vertex whose handle is under a position; of equally near ones the last, which is drawn on
/// top. In a crowded view, vertices without a handle are hit only from very near.
std::optional<VertexRef> vertexAt(const QPointF &position, const CanvasSources &sources,
                                  const CanvasView &view, const OutlineChoice &choice);

/// Whether the off-screen point is under a position.
bool isOffScreenPointAt(const QPointF &position, const SceneDocument &document,
                        const CanvasView &view);

/// Null where the run's frame is not the document's.
const TracedScene *tracedOfFrame(const SceneDocument &document, const Playhead &playhead);

} // namespace pixelplumb
