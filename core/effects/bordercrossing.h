// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/framereach.h"

namespace pixelplumb {

/// Where a primitive is, seen from the frame's border.
enum class BorderCrossing : std::uint8_t {
    Within, ///< every sample, every pixel that it has a part of, is the frame's
    Crosses,
    MayCross, ///< by its bounding box; where its line runs was not looked at
    Outside, ///< nothing of the frame is within its bounding box
};

/// Whether the triangle has samples in the frame and beyond it. Where pixels have more than one
/// sample these count, where areas are covered all that a pixel has of it. Exact, but for one whose
/// numbers are rounded, which crosses where its bounding box does, and a sliver of very many rows.
BorderCrossing borderCrossingOf(const Triangle &triangle, const SampledFrame &where);
/// An antialiased line or curve is one pixel wide.
BorderCrossing borderCrossingOf(const Shape &shape, const SampledFrame &where);
/// Whether antialiasing changes a line or curve: its border meets a pixel of the frame (see
/// hasEdgePixels), and it is drawn so, or would be without.
bool callsForAntialiasing(const Shape &stroke, const SampledFrame &where);

} // namespace pixelplumb
