// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvasscene.h"

namespace pixelplumb {

/// What a screen reader says of the vertex, the corner of an image or the pixel in hand.
QString spokenState(const CanvasSources &sources, const CanvasHand &hand);

/// Lets screen readers ask a Canvas for the pixel or vertex in hand, as its value. Harmless when
/// called again.
void installCanvasAccessible();

} // namespace pixelplumb
