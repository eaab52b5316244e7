// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <span>

namespace pixelplumb {

/// The shape that corners in space form.
enum class PolygonShape : std::uint8_t {
    Convex,
    Flattened, ///< the corners are collinear
    Bent, ///< the corners are not coplanar
    Concave, ///< or self-intersecting
};

/// Needs at least three corners. Planarity and turns are judged within 10^-9 of the polygon's
/// extent, since corners in an inclined plane are rounded.
PolygonShape shapeOf(std::span<const SolidCorner> corners);

} // namespace pixelplumb
