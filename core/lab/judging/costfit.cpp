// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/costfit.h"

#include <array>
#include <cmath>
#include <utility>

namespace pixelplumb {

namespace {

using Parts = std::array<double, 3>;

Parts workOf(const CostPoint &point) { return {point.triangles, point.columns, point.pixels}; }

/// Solves the normal equations of the chosen parts by elimination with the largest pivot; the
/// others are 0. None if the points do not separate the parts.
std::optional<Parts> leastSquares(std::span<const CostPoint> points, unsigned chosen)
{
    std::array<std::array<double, 4>, 3> rows = {};
    for (std::size_t i = 0; i < 3; ++i) {
        if ((chosen >> i & 1U) == 0) {
            rows[i][i] = 1;
            continue;
        }
        for (const CostPoint &point : points) {
            const Parts work = workOf(point);
            const double weight = 1 / (point.nanoseconds * point.nanoseconds);
            for (std::size_t j = 0; j < 3; ++j) {
                if ((chosen >> j & 1U) != 0)
                    rows[i][j] += weight * work[i] * work[j];
            }
            rows[i][3] += weight * work[i] * point.nanoseconds;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        std::size_t largest = i;
        for (std::size_t k = i + 1; k < 3; ++k) {
            if (std::abs(rows[k][i]) > std::abs(rows[largest][i]))
                largest = k;
        }
        std::swap(rows[i], rows[largest]);
        if (rows[i][i] == 0)
            return std::nullopt;
        for (std::size_t k = 0; k < 3; ++k) {
            if (k == i)
                continue;
            const double factor = rows[k][i] / rows[i][i];
            for (std::size_t j = i; j < 4; ++j)
                rows[k][j] -= factor * rows[i][j];
        }
    }
    return Parts{rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

} // namespace

std::optional<CostFit> fitCost(std::span<const CostPoint> points)
{
    if (points.size() < 3)
        return std::nullopt;
    // With three parts, every set of those that may be above 0 can be tried.
    std::optional<CostFit> best;
    for (unsigned chosen = 1; chosen < 8; ++chosen) {
        const auto parts = leastSquares(points, chosen);
        if (!parts || (*parts)[0] < 0 || (*parts)[1] < 0 || (*parts)[2] < 0)
            continue;
        CostFit fit{(*parts)[0], (*parts)[1], (*parts)[2], 0};
        double squares = 0;
        for (const CostPoint &point : points) {
            const double relative = fit.at(point) / point.nanoseconds - 1;
            squares += relative * relative;
        }
        fit.residual = std::sqrt(squares / double(points.size()));
        if (std::isfinite(fit.residual) && (!best || fit.residual < best->residual))
            best = fit;
    }
    return best;
}

} // namespace pixelplumb
