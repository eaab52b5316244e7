// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of filled Bézier paths: of the curves themselves, not of chords. The path is its
/// pieces, one after another, with a straight edge wherever a piece does not begin at the end of
/// the one before, and from the last to the first. Samples are displaced to the right and, less,
/// down as seen, as those of a polygon are (polygonoracle.h).
///
/// What a piece adds to the winding number of the samples on a row is decided in integers. A piece
/// all above or all below the row adds nothing. One that lies between two columns adds ±1, where
/// one of its ends is above the row and the other below, to all samples to the right of it, however
/// often it crosses. Any other is halved, until it is 2^-28 of a curve's parameter: then its chord
/// stands for it. So only a sample that lies on a bent curve, or within some 2^-56 of its size, may
/// be wrong.
namespace pixelplumb::oracle {

bool filledCurveCovers(const Shape &path, FrameOrigin origin, std::int64_t x, std::int64_t y);
/// In the first vertex's colour.
void drawFilledCurve(const Shape &path, FrameView frame);

} // namespace pixelplumb::oracle
