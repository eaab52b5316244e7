// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/quantity.h"

#include <cstdint>

namespace pixelplumb {

/// How much of a pixel's square, [x − ½, x + ½] × [y − ½, y + ½] in sample coordinates, a triangle
/// covers: 0 … 1. A double with a bound of its error, made exact where a byte depends on it
/// (clipped as Sutherland and Hodgman 1974 clip).
class PixelArea {
public:
    PixelArea(const Triangle &triangle, std::int64_t x, std::int64_t y);

    bool isEmpty() const;
    /// ⌊α·area + ½⌋, exactly.
    std::uint8_t times(std::uint8_t alpha) const;
    /// The fraction itself; the nearest double where 128 bits do not hold it.
    Quantity exact() const;

private:
    const Triangle *m_triangle; ///< outlives this
    std::int64_t m_x;
    std::int64_t m_y;
    double m_area = 0;
    double m_error = 0; ///< at most
};

} // namespace pixelplumb
