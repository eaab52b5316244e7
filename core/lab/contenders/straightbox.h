// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/contenders/straightloop.h"

#include <algorithm>

/// The common parts of the straight loops that test samples.
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

/// Edge equations are printed row by row, barycentric coordinates column by column.
enum class StraightLines { OfEdges, OfWeights };

/// Which vertex a line faces: the order in which the lines are tested and summed up.
constexpr std::size_t facedVertex(StraightLines lines, std::size_t line)
{
    return lines == StraightLines::OfWeights ? line : (line + 2) % 3;
}

/// Whether a sample exactly on a line a·x + b·y + c belongs to the side where it is positive.
template <class Number>
bool straightOwnsTie(StraightRule rule, const Number &a, const Number &b)
{
    if (rule == StraightRule::Closed)
        return true;
    return b == Number(0) ? a > Number(0) : b > Number(0);
}

} // namespace pixelplumb
