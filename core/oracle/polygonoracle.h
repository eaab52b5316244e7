// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of polygons. Of an outline it is that of its edges as lines (lineoracle.h). Of a
/// filled one it is found for every sample by itself. From the sample a ray runs to the
/// left; what counts is how often the contours cross it (even-odd) or how often more upward than
/// downward (non-zero). A crossing is the sign of a product of differences in 128 bits: no slope,
/// no quotient, nothing that goes from one row to the next.
///
/// A sample on the boundary is taken as if displaced right and, less, down as seen: the rule
/// top-left. A displaced sample lies on no edge and on no vertex, so that its parity and its
/// winding number are certain, and so that polygons which share an edge cover each of its samples
/// once.
namespace pixelplumb::oracle {

/// Sample coordinates; any sample within ±2^30 px.
bool polygonCovers(const Shape &polygon, FrameOrigin origin, std::int64_t x, std::int64_t y);

/// Draws the true picture in the first vertex's colour over what the frame holds and notes what it
/// covers.
void drawPolygon(const Shape &polygon, FrameView frame);

} // namespace pixelplumb::oracle
