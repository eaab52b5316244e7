// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/framereach.h"

namespace pixelplumb {

/// How a primitive lies relative to the frame's border.
enum class BorderCrossing : std::uint8_t {
    Within, ///< every sample, or every pixel that it partly covers, is in the frame
    Crosses,
    MayCross, ///< its bounding box does; where its outline runs was not checked
    Outside, ///< its bounding box, or that of each of its parts, holds nothing of the frame
};

/// The crossing of a bounding box, its boundary included.
BorderCrossing crossingOfBox(const SampleBox &box, const FrameView &frame);
/// Whether the triangle has samples both inside and outside the frame: with 4 or 16 samples those,
/// with area antialiasing any part of a pixel. Exact, except for a triangle with rounded numbers,
/// which crosses where its bounding box does, and for a sliver of very many rows.
BorderCrossing borderCrossingOf(const Triangle &triangle, const SampledFrame &where);
/// An antialiased line or curve is one pixel wide.
BorderCrossing borderCrossingOf(const Shape &shape, const SampledFrame &where);
/// Whether antialiasing changes a line or curve: its border meets a pixel of the frame (see
/// hasEdgePixels), and it is drawn with antialiasing, or would be without.
bool callsForAntialiasing(const Shape &stroke, const SampledFrame &where);

} // namespace pixelplumb
