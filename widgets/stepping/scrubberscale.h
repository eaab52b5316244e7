// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pixelplumb {

/// Positions 0 … end spread evenly over a stretch of the screen, in logical pixels.
struct ScrubberScale {
    double left = 0;
    double width = 1;
    std::size_t end = 0;

    double xOf(std::size_t position) const
    {
        return end == 0 ? left : left + width * (double(position) / double(end));
    }
    /// The nearest position, also from outside the stretch.
    std::size_t positionAt(double x) const
    {
        const double share = std::clamp((x - left) / std::max(1.0, width), 0.0, 1.0);
        return std::size_t(std::llround(share * double(end)));
    }
};

} // namespace pixelplumb
