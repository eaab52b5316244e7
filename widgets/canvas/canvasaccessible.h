// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/canvas/canvasscene.h"

namespace pixelplumb {

/// What a screen reader says of the current vertex, image corner or pixel.
QString spokenState(const CanvasSources &sources, const CanvasHand &hand);

/// Exposes the current pixel or vertex to screen readers as a Canvas's value. Harmless when called
/// again.
void installCanvasAccessible();

} // namespace pixelplumb
