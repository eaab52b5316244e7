// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

namespace pixelplumb {

/// How far a sample is from the triangle's boundary, px, inside or outside: exactly 0 on it, and
/// nowhere else; else the double that is nearest but for some rounding. The triangle must have an
/// area.
double distanceToBoundary(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
