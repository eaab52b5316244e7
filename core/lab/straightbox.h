// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <algorithm>

/// What the straight loops that test samples have in common.
namespace pixelplumb {

/// The samples in a triangle's bounding box.
struct StraightBox {
    std::int64_t left, right, low, high; ///< all included
};

inline StraightBox straightBoxOf(const Triangle &triangle)
{
    const auto &[a, b, c] = triangle.vertices;
    const auto [left, right] = std::minmax({a.position.x, b.position.x, c.position.x});
    const auto [low, high] = std::minmax({a.position.y, b.position.y, c.position.y});
    return {ceilPixel(left), floorPixel(right), ceilPixel(low), floorPixel(high)};
}

/// Line i faces vertex (i + 2) % 3 of edge equations, vertex i of barycentric coordinates.
constexpr std::size_t facedVertex(bool isBarycentric, std::size_t line)
{
    return isBarycentric ? line : (line + 2) % 3;
}

} // namespace pixelplumb
