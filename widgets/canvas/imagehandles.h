// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layermoment.h"
#include "widgets/canvas/canvasscene.h"
#include "widgets/model/renumbering.h"

namespace pixelplumb {

/// Null while the run is not that of the scene, and where the truth stands in the frame's place.
const TracedScene *runInView(const CanvasSources &sources);

/// The triangle's image under the affine map of the layer that is switched on; none where it draws
/// none, or one of a triangle without an area.
std::optional<AffineImage> imageInView(const CanvasSources &sources);

/// The corner of that image under a position: 0, 1 or 2, of equally near ones the last.
std::optional<std::size_t> imageCornerAt(const QPointF &position, const CanvasSources &sources,
                                         const CanvasView &view);

/// Asks for an image with one corner elsewhere, where the document's snap puts it; beyond ±2^30 px
/// nothing happens. Moves that share a drag number are one edit.
void moveImageCorner(const CanvasSources &sources, AffineImage image, std::size_t corner,
                     const LatticePoint &target, int drag);

/// The image that was asked for of a triangle which is not drawn now: hidden, or taken away.
struct ImageOfUndrawn {
    Triangle triangle;
    Corners corners;
};

/// Lets the image that is asked for go with its triangle; where that goes altogether, what is left
/// of it is kept.
void followTriangle(const CanvasSources &sources, const TriangleRenumbering &numberAfter,
                    std::optional<ImageOfUndrawn> &kept);

/// Asks again for the image of a triangle that is drawn again, unless another was asked for since.
void bringBackImage(const CanvasSources &sources, std::optional<ImageOfUndrawn> &kept);

/// The image's corners, in the colours of the vertices whose images they are.
void addImageHandles(CanvasScene &scene, const CanvasSources &sources, const CanvasView &view,
                     const CanvasHand &hand);

} // namespace pixelplumb
