// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace pixelplumb {

/// A draw: how much work it was and how long it took.
struct CostPoint {
    double triangles = 0;
    double columns = 0; ///< or rows, of a walk over rows
    double pixels = 0;
    double nanoseconds = 0;
};

/// t = a·triangles + b·columns + c·pixels, ns: what set-up, columns and pixels take by themselves.
struct CostFit {
    double perTriangle = 0;
    double perColumn = 0;
    double perPixel = 0;
    double residual = 0; ///< root mean square of the relative differences, 0 …

    double at(const CostPoint &point) const
    {
        return perTriangle * point.triangles + perColumn * point.columns + perPixel * point.pixels;
    }

    friend bool operator==(const CostFit &, const CostFit &) = default;
};

/// The least-squares fit of the relative differences, with no coefficient below 0. None for fewer
/// than three points.
std::optional<CostFit> fitCost(std::span<const CostPoint> points);

} // namespace pixelplumb
