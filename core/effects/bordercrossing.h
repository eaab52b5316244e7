// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/shape.h"

namespace pixelplumb {

/// Where a primitive is, seen from the frame's border.
enum class BorderCrossing : std::uint8_t {
    Within, ///< every sample of it is the frame's
    Crosses,
    MayCross, ///< by its bounding box; where its line runs was not looked at
    Outside, ///< no sample of the frame is within its bounding box
};

/// Exact: whether the triangle meets the frame's samples and has a box beyond them.
BorderCrossing borderCrossingOf(const Triangle &triangle, const FrameView &frame);
BorderCrossing borderCrossingOf(const Shape &shape, const FrameView &frame);

} // namespace pixelplumb
