// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/coveragemask.h"
#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

/// The truth of Bézier curves. De Casteljau's subdivision in the middle is exact in binary
/// fractions: each halving of a curve of degree n adds n bits. The curve is halved until the
/// control points of a piece lie within 1/4 px of each other in x and in y, or 33 times, which only
/// curves of more than 2^28 px need; its pixels are those nearest to the ends of these pieces, the
/// upper and the right one of those that are equally near.
namespace pixelplumb::oracle {

bool curveCovers(const Shape &curve, std::int64_t x, std::int64_t y);
/// In the first vertex's colour.
void drawCurve(const Shape &curve, FrameView frame, CoverageMask &coverage);

} // namespace pixelplumb::oracle
