// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

#include <span>

namespace pixelplumb {

/// What corners in space make.
enum class PolygonShape : std::uint8_t {
    Convex,
    Flattened, ///< they stand on one line
    Bent, ///< they are not in one plane
    Concave, ///< or it crosses itself
};

/// Three corners or more. Planes and turns are judged within 10^-9 of the polygon's extent, since
/// corners in an inclined plane are rounded.
PolygonShape shapeOf(std::span<const SolidCorner> corners);

} // namespace pixelplumb
