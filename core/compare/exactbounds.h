// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/quantity.h"
#include "core/trace/tracerecords.h"

namespace pixelplumb {

/// Where a triangle's exact edges meet a column (y_B, y_T) or a row (x_L, x_R), px.
struct ExactBounds {
    Quantity lower, upper;
};

/// From the oracle. None where the triangle does not meet the column or row, and for free spans.
std::optional<ExactBounds> exactBoundsOn(const Triangle &triangle, const SpanPlace &place);

/// Whether a sample lies in the triangle's bounding box: a cheap test before asking the oracle.
bool isInBox(const Triangle &triangle, std::int64_t x, std::int64_t y);

/// Whether a sample lies exactly on the triangle's boundary: a tie, which the fill rule decides.
bool liesOnBoundary(const Triangle &triangle, std::int64_t x, std::int64_t y);

} // namespace pixelplumb
