// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lab/judging/missdistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

/// The distance of a point from the segment between two others, lattice units.
double distanceToSegment(const LatticePoint &p, const LatticePoint &a, const LatticePoint &b)
{
    const Int128 alongX = b.x - a.x, alongY = b.y - a.y;
    const Int128 fromX = p.x - a.x, fromY = p.y - a.y;
    const Int128 projection = fromX * alongX + fromY * alongY;
    const Int128 squaredLength = alongX * alongX + alongY * alongY;
    if (projection <= 0)
        return std::hypot(double(fromX), double(fromY));
    if (projection >= squaredLength)
        return std::hypot(double(p.x - b.x), double(p.y - b.y));
    return std::abs(double(alongX * fromY - alongY * fromX)) / std::sqrt(double(squaredLength));
}

} // namespace

double distanceToBoundary(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const LatticePoint sample = latticePixel(x, y);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &a = triangle.vertices[i].position;
        const LatticePoint &b = triangle.vertices[(i + 1) % 3].position;
        nearest = std::min(nearest, distanceToSegment(sample, a, b));
    }
    return nearest / double(unitsPerPixel);
}

} // namespace pixelplumb
