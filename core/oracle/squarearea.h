// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/wideinteger.h"

namespace pixelplumb::oracle {

/// How much of the square [x − ½, x + ½] × [y − ½, y + ½] the triangle covers, 0 … 1: by
/// clipping it at the four sides (Sutherland and Hodgman 1974) in rational numbers.
BigRational areaInSquare(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// Whether an edge of the triangle, its ends included, meets that square, its sides included.
bool edgeMeetsSquare(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb::oracle
