// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/polygonshape.h"

#include "core/space/spacevector.h"

#include <algorithm>

namespace pixelplumb {

PolygonShape shapeOf(std::span<const SolidCorner> corners)
{
    using Vector = SpaceVector<double>;
    constexpr double tolerance = 1e-9;
    const std::size_t count = corners.size();
    const auto arm = [corners](std::size_t from, std::size_t to) {
        return Vector(corners[to].position) - Vector(corners[from].position);
    };
    Vector doubledArea; // Newell 1972: the sum over the fan
    double extent = 0;
    for (std::size_t i = 1; i < count; ++i) {
        extent = std::max(extent, lengthOf(arm(0, i)));
        if (i + 1 < count)
            doubledArea = doubledArea + cross(arm(0, i), arm(0, i + 1));
    }
    if (lengthOf(doubledArea) <= tolerance * extent * extent)
        return PolygonShape::Flattened;
    const Vector normal = unit(doubledArea);
    for (std::size_t i = 1; i < count; ++i) {
        if (std::abs(dot(normal, arm(0, i))) > tolerance * extent)
            return PolygonShape::Bent;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const auto turn
            = [&](const Vector &a, const Vector &b) { return dot(normal, cross(a, b)); };
        const double smallest = -tolerance * extent * extent;
        if (turn(arm(i, next), arm(next, (i + 2) % count)) < smallest
            || turn(arm(0, i), arm(0, next)) < smallest)
            return PolygonShape::Concave;
    }
    return PolygonShape::Convex;
}

} // namespace pixelplumb
