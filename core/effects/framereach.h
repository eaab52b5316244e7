// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/edgeteststate.h"

namespace pixelplumb {

/// What of the frame a triangle may touch, from above and without scanning it.

/// The pixels of the frame within the triangle's bounding box. Where pixels have more than one
/// sample, those whose closed square meets the box.
SampleBox reachOf(const Triangle &triangle, const FrameView &frame, Antialiasing antialiasing);
/// How many of them it may cover: no more than its reach, and no more than A + P/2 + 1 of any
/// convex figure of area A and perimeter P (Nosarzewska 1948). Where pixels have more than one
/// sample that figure is the triangle widened by half a pixel's square on every side.
std::int64_t mostPixelsOf(const Triangle &triangle, const SampleBox &reach,
                          Antialiasing antialiasing);
/// How many pixels of the frame a line or curve one pixel wide may touch: of a line no more than
/// the same says of its segment widened by one pixel on every side; of a curve all of them.
std::int64_t mostPixelsOf(const Shape &stroke, const FrameView &frame);
/// Through how many of them an edge may pass.
std::int64_t mostEdgePixelsOf(const Triangle &triangle, const SampleBox &reach);

} // namespace pixelplumb
