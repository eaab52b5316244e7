// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/wideinteger.h"

namespace pixelplumb::oracle {

/// The area of the square [x − ½, x + ½] × [y − ½, y + ½] that the triangle covers, 0 … 1: by
/// clipping at its four sides (Sutherland and Hodgman 1974) in rational numbers.
BigRational areaInSquare(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// Whether an edge of the triangle, ends included, meets that square, sides included.
bool edgeMeetsSquare(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb::oracle
