// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/exactbounds.h"

#include "core/oracle/oracle.h"

#include <algorithm>

namespace pixelplumb {

std::optional<ExactBounds> exactBoundsOn(const Triangle &triangle, const SpanPlace &place)
{
    if (place.axis == SpanAxis::Free)
        return std::nullopt;
    Triangle turned = triangle;
    if (place.axis == SpanAxis::Row) { // a row is a column of the triangle mirrored at x = y
        for (Vertex &vertex : turned.vertices)
            std::swap(vertex.position.x, vertex.position.y);
    }
    const auto column = oracle::columnAt(turned, FillRule::Closed, place.coordinate);
    if (!column)
        return std::nullopt;
    return ExactBounds{column->yBottom, column->yTop};
}

bool isInBox(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const LatticePoint sample = latticePixel(x, y);
    const auto &v = triangle.vertices;
    const auto [left, right] = std::minmax({v[0].position.x, v[1].position.x, v[2].position.x});
    const auto [low, high] = std::minmax({v[0].position.y, v[1].position.y, v[2].position.y});
    return sample.x >= left && sample.x <= right && sample.y >= low && sample.y <= high;
}

bool liesOnBoundary(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    if (!isInBox(triangle, x, y))
        return false;
    const oracle::SampleVerdict verdict = oracle::judge(triangle, FillRule::Closed, x, y);
    if (!verdict.covered)
        return false;
    return verdict.zeroArea
        || std::ranges::any_of(verdict.edges, [](const oracle::EdgeVerdict &edge) {
               return edge.edgeFunction == 0;
           });
}

} // namespace pixelplumb
