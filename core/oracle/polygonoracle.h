// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of polygons. An outline is its edges as lines (lineoracle.h). A filled polygon is
/// decided for each sample independently by a ray from the sample to the left: by how often the
/// contours cross it (even-odd), or how much more often upward than downward (non-zero). A crossing
/// is the sign of a product of differences in 128 bits: no slope, no quotient, nothing carried from
/// one row to the next.
///
/// A sample on the boundary counts as displaced to the right and, by less, down on screen: the rule
/// top-left. A displaced sample lies on no edge and no vertex, so its parity and winding number are
/// certain, and polygons that share an edge cover each of its samples once.
namespace pixelplumb::oracle {

/// Sample coordinates; any sample within ±2^30 px.
bool polygonCovers(const Shape &polygon, FrameOrigin origin, std::int64_t x, std::int64_t y);

/// Draws the true picture in the first vertex's colour over the frame's content.
void drawPolygon(const Shape &polygon, FrameView frame);

} // namespace pixelplumb::oracle
