// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

namespace pixelplumb {

/// A sample's distance from the triangle's boundary, px, inside or outside: exactly 0 on it, and
/// nowhere else; otherwise the nearest double but for some rounding. The triangle must have area.
double distanceToBoundary(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
