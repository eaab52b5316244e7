// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scan/mistakes/walkcorners.h"

#include <algorithm>
#include <vector>

namespace pixelplumb {

namespace {

/// The positions that are compared, one pair after another, and swapped where the second's x is
/// less.
std::vector<std::array<std::size_t, 2>> comparisonsOf(VertexOrder vertices)
{
    switch (vertices) {
    case VertexOrder::Compared01:
        return {{0, 1}};
    case VertexOrder::Compared12:
        return {{1, 2}};
    case VertexOrder::Compared02:
        return {{0, 2}};
    case VertexOrder::Compared01And12:
        return {{0, 1}, {1, 2}};
    case VertexOrder::Compared12And01:
        return {{1, 2}, {0, 1}};
    case VertexOrder::Compared01And02:
        return {{0, 1}, {0, 2}};
    case VertexOrder::Compared02And12:
        return {{0, 2}, {1, 2}};
    case VertexOrder::ByX:
    case VertexOrder::ByXThenAsGiven:
    case VertexOrder::ByXThenDown:
    case VertexOrder::ByY:
    case VertexOrder::AsGiven:
        break;
    }
    return {};
}

} // namespace

std::array<int, 3> vertexOrderOf(const Triangle &triangle, VertexOrder vertices)
{
    if (vertices == VertexOrder::ByX)
        return sortedByColumn(triangle);
    std::array<int, 3> order = {0, 1, 2};
    const auto placeOf = [&](int index) -> const LatticePoint & {
        return triangle.vertices[std::size_t(index)].position;
    };
    for (const auto &[first, second] : comparisonsOf(vertices)) {
        if (placeOf(order[second]).x < placeOf(order[first]).x)
            std::swap(order[first], order[second]);
    }
    if (vertices == VertexOrder::ByY)
        std::ranges::stable_sort(order, {}, [&](int index) { return placeOf(index).y; });
    const bool isByX
        = vertices == VertexOrder::ByXThenAsGiven || vertices == VertexOrder::ByXThenDown;
    if (isByX)
        std::ranges::stable_sort(order, {}, [&](int index) {
            const LatticePoint &place = placeOf(index);
            return LatticePoint{place.x, vertices == VertexOrder::ByXThenDown ? -place.y : 0};
        });
    return order;
}

} // namespace pixelplumb
