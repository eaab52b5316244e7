// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/contours.h"

#include <algorithm>

namespace pixelplumb {

Contours contoursOf(const Shape &polygon)
{
    Contours contours;
    contours.fill = polygon.fill;
    if (polygon.vertices.empty())
        return contours;
    contours.colour = polygon.vertices.front().colour;
    contours.edges.reserve(polygon.vertices.size());
    std::size_t first = 0;
    const auto close = [&](std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const std::size_t next = i + 1 < end ? i + 1 : first;
            contours.edges.push_back(
                {polygon.vertices[i].position, polygon.vertices[next].position});
        }
        contours.count += std::size_t(first < end);
        first = std::max(first, end);
    };
    for (const std::size_t start : polygon.laterContours)
        close(std::min(start, polygon.vertices.size()));
    close(polygon.vertices.size());
    return contours;
}

ContourBox boxAround(std::span<const ContourEdge> edges)
{
    ContourBox box;
    if (edges.empty())
        return box;
    box.first = box.last = edges.front().from;
    // Every vertex begins an edge.
    for (const ContourEdge &edge : edges) {
        box.first = {std::min(box.first.x, edge.from.x), std::min(box.first.y, edge.from.y)};
        box.last = {std::max(box.last.x, edge.from.x), std::max(box.last.y, edge.from.y)};
    }
    return box;
}

IntegerWidth integerWidthFor(std::span<const ContourEdge> edges)
{
    const bool isWide
        = std::ranges::any_of(edges, [](const ContourEdge &edge) { return !isNarrow(edge.from); });
    return isWide ? IntegerWidth::Bits128 : IntegerWidth::Bits64;
}

} // namespace pixelplumb
