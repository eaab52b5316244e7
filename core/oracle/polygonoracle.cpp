// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/polygonoracle.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// An edge from its lower end to its upper one.
struct UpwardEdge {
    LatticePoint low;
    LatticePoint high;
    int turn = 0; ///< +1 where the contour runs upward, −1 where it runs downward

    /// The rows that it crosses lie in (low.y, high.y]: displaced by −ε², a sample level with the
    /// lower end is below the edge, and one level with the upper end is not above it.
    bool crossesHeight(Lattice y) const { return low.y < y && y <= high.y; }

    /// Displaced by +ε, a sample exactly on the edge is to the right of it.
    bool isLeftOf(const LatticePoint &sample) const
    {
        return Int128(high.x - low.x) * (sample.y - low.y)
            <= Int128(high.y - low.y) * (sample.x - low.x);
    }
};

std::vector<UpwardEdge> upwardEdgesOf(const Shape &polygon)
{
    std::vector<UpwardEdge> edges;
    const auto &vertices = polygon.vertices;
    const auto &starts = polygon.laterContours;
    std::size_t contourFirst = 0;
    auto nextStart = starts.begin();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const bool endsContour
            = i + 1 == vertices.size() || (nextStart != starts.end() && i + 1 == *nextStart);
        const LatticePoint &from = vertices[i].position;
        const LatticePoint &to = vertices[endsContour ? contourFirst : i + 1].position;
        if (from.y < to.y)
            edges.push_back({from, to, 1});
        else if (from.y > to.y)
            edges.push_back({to, from, -1});
        if (endsContour) {
            contourFirst = i + 1;
            if (nextStart != starts.end())
                ++nextStart;
        }
    }
    return edges;
}

bool isInside(const std::vector<UpwardEdge> &edges, ShapeFill fill, const LatticePoint &sample)
{
    std::int64_t crossings = 0;
    std::int64_t winding = 0;
    for (const UpwardEdge &edge : edges) {
        if (!edge.crossesHeight(sample.y) || !edge.isLeftOf(sample))
            continue;
        ++crossings;
        winding += edge.turn;
    }
    return fill == ShapeFill::NonZero ? winding != 0 : crossings % 2 != 0;
}

} // namespace

bool polygonCovers(const Shape &polygon, std::int64_t x, std::int64_t y)
{
    return isInside(upwardEdgesOf(polygon), polygon.fill, latticePixel(x, y));
}

void drawPolygon(const Shape &polygon, FrameView frame, CoverageMask &coverage)
{
    if (polygon.vertices.empty())
        return;
    const auto byX = [](const Vertex &a, const Vertex &b) { return a.position.x < b.position.x; };
    const auto [left, right] = std::ranges::minmax_element(polygon.vertices, byX);
    const std::int64_t firstX
        = std::max<std::int64_t>(ceilPixel(left->position.x), frame.firstColumn);
    const std::int64_t endX = std::min(floorPixel(right->position.x) + 1, frame.endColumn());
    const std::vector<UpwardEdge> edges = upwardEdgesOf(polygon);
    std::vector<UpwardEdge> atHeight;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        // Only the edges that any sample of this row can cross, so that thousands cost little.
        atHeight.clear();
        std::ranges::copy_if(edges, std::back_inserter(atHeight), [y](const UpwardEdge &edge) {
            return edge.crossesHeight(y * unitsPerPixel);
        });
        for (std::int64_t x = firstX; x < endX && !atHeight.empty(); ++x) {
            if (!isInside(atHeight, polygon.fill, latticePixel(x, y)))
                continue;
            *frame.at(x, y) = packed(polygon.vertices.front().colour);
            coverage.cover(x, y);
        }
    }
}

} // namespace pixelplumb::oracle
