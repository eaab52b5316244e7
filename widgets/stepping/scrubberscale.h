// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace pixelplumb {

/// A column's place on the screen.
struct ColumnStop {
    std::size_t position = 0; ///< just after it was entered
    double x = 0; ///< its middle, logical pixels; ascending with the position
};

/// Maps positions 0 … end to a stretch of the screen, in logical pixels: spread evenly or, where
/// there are stops, each at its column.
struct ScrubberScale {
    double left = 0;
    double width = 1;
    std::size_t end = 0;
    std::span<const ColumnStop> stops = {};

    double xOf(std::size_t position) const
    {
        if (stops.empty())
            return end == 0 ? left : left + width * (double(position) / double(end));
        const auto next = std::ranges::upper_bound(stops, position, {}, &ColumnStop::position);
        return next == stops.begin() ? left : std::prev(next)->x;
    }
    /// The position nearest to x, also from outside the stretch; for a column, the one just after
    /// it was entered.
    std::size_t positionAt(double x) const
    {
        if (stops.empty()) {
            const double share = std::clamp((x - left) / std::max(1.0, width), 0.0, 1.0);
            return std::size_t(std::llround(share * double(end)));
        }
        if (x >= left + width)
            return end;
        const auto next = std::ranges::lower_bound(stops, x, {}, &ColumnStop::x);
        if (next == stops.end())
            return stops.back().position;
        const double before = next == stops.begin() ? left : std::prev(next)->x;
        if (next->x - x <= x - before)
            return next->position;
        return next == stops.begin() ? 0 : std::prev(next)->position;
    }
};

} // namespace pixelplumb
