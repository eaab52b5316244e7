// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of filled Bézier paths: of the curves themselves, not of chords. The path is its
/// pieces in order, with a straight edge wherever a piece does not begin at the end of the one
/// before, and from the last to the first. Samples are displaced to the right and, by less, down on
/// screen, as for polygons (polygonoracle.h).
///
/// A piece's contribution to the winding numbers of a row's samples is decided in integers. A piece
/// entirely above or below the row adds nothing. One that lies between two columns, with one end
/// above the row and the other below, adds ±1 to all samples to the right of it, however often it
/// crosses. Any other is halved, until it is 2^-28 of a curve's parameter: then its chord stands
/// for it. So only a sample on a bent curve, or within some 2^-56 of the curve's size from it, may
/// be wrong.
namespace pixelplumb::oracle {

bool filledCurveCovers(const Shape &path, FrameOrigin origin, std::int64_t x, std::int64_t y);
/// Draws it in the first vertex's colour.
void drawFilledCurve(const Shape &path, FrameView frame);

} // namespace pixelplumb::oracle
