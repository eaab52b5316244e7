// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/number/quantity.h"

#include <cstdint>

namespace pixelplumb {

/// How much of a pixel's square, [x − ½, x + ½] × [y − ½, y + ½] in sample coordinates, a triangle
/// covers: 0 … 1. A double with an error bound, computed exactly where a byte depends on it (by
/// Sutherland-Hodgman clipping, 1974).
class PixelArea {
public:
    PixelArea(const Triangle &triangle, std::int64_t x, std::int64_t y);

    bool isEmpty() const;
    /// ⌊α·area + ½⌋, exactly.
    std::uint8_t times(std::uint8_t alpha) const;
    /// The exact fraction; the nearest double where it does not fit 128 bits.
    Quantity exact() const;

private:
    const Triangle *m_triangle; ///< must outlive this
    std::int64_t m_x;
    std::int64_t m_y;
    double m_area = 0;
    double m_error = 0; ///< upper bound
};

} // namespace pixelplumb
