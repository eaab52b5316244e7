// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/polygonoracle.h"

#include "core/oracle/lineoracle.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

/// An edge from its lower to its upper end.
struct UpwardEdge {
    LatticePoint low;
    LatticePoint high;
    int turn = 0; ///< +1 where the contour runs upward, −1 where it runs downward

    /// Displaced down on screen, a sample level with the lower end on screen is below the edge, and
    /// one level with the other end is not above it.
    bool crossesHeight(Lattice y, FrameOrigin origin) const
    {
        return origin == FrameOrigin::TopLeft ? low.y <= y && y < high.y : low.y < y && y <= high.y;
    }

    /// Displaced by +ε, a sample exactly on the edge is to the right of it.
    bool isLeftOf(const LatticePoint &sample) const
    {
        return Int128(high.x - low.x) * (sample.y - low.y)
            <= Int128(high.y - low.y) * (sample.x - low.x);
    }
};

/// Calls a function with the two ends of each edge, contour after contour.
template <class Function>
void forEachEdge(const Shape &polygon, const Function &function)
{
    const auto &vertices = polygon.vertices;
    const auto &starts = polygon.laterContours;
    std::size_t contourFirst = 0;
    auto nextStart = starts.begin();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const bool endsContour
            = i + 1 == vertices.size() || (nextStart != starts.end() && i + 1 == *nextStart);
        const LatticePoint &from = vertices[i].position;
        const LatticePoint &to = vertices[endsContour ? contourFirst : i + 1].position;
        function(from, to);
        if (endsContour) {
            contourFirst = i + 1;
            if (nextStart != starts.end())
                ++nextStart;
        }
    }
}

std::vector<UpwardEdge> upwardEdgesOf(const Shape &polygon)
{
    std::vector<UpwardEdge> edges;
    forEachEdge(polygon, [&edges](const LatticePoint &from, const LatticePoint &to) {
        if (from.y < to.y)
            edges.push_back({from, to, 1});
        else if (from.y > to.y)
            edges.push_back({to, from, -1});
    });
    return edges;
}

std::vector<Shape> edgeLinesOf(const Shape &polygon)
{
    std::vector<Shape> lines;
    forEachEdge(polygon, [&](const LatticePoint &from, const LatticePoint &to) {
        const Colour &colour = polygon.vertices.front().colour;
        lines.emplace_back().vertices = {{from, colour}, {to, colour}};
    });
    return lines;
}

bool isInside(const std::vector<UpwardEdge> &edges, ShapeFill fill, FrameOrigin origin,
              const LatticePoint &sample)
{
    std::int64_t crossings = 0;
    std::int64_t winding = 0;
    for (const UpwardEdge &edge : edges) {
        if (!edge.crossesHeight(sample.y, origin) || !edge.isLeftOf(sample))
            continue;
        ++crossings;
        winding += edge.turn;
    }
    return fill == ShapeFill::NonZero ? winding != 0 : crossings % 2 != 0;
}

} // namespace

bool polygonCovers(const Shape &polygon, FrameOrigin origin, std::int64_t x, std::int64_t y)
{
    if (polygon.fill == ShapeFill::Outline)
        return std::ranges::any_of(edgeLinesOf(polygon),
                                   [&](const Shape &line) { return lineCovers(line, x, y); });
    return isInside(upwardEdgesOf(polygon), polygon.fill, origin, latticePixel(x, y));
}

void drawPolygon(const Shape &polygon, FrameView frame)
{
    if (polygon.vertices.empty())
        return;
    if (polygon.fill == ShapeFill::Outline) {
        for (const Shape &line : edgeLinesOf(polygon))
            drawLine(line, ByteRounding::Nearest, frame);
        return;
    }
    const auto byX = [](const Vertex &a, const Vertex &b) { return a.position.x < b.position.x; };
    const auto [left, right] = std::ranges::minmax_element(polygon.vertices, byX);
    const std::int64_t firstX
        = std::max<std::int64_t>(ceilPixel(left->position.x), frame.firstColumn);
    const std::int64_t endX = std::min(floorPixel(right->position.x) + 1, frame.endColumn());
    const std::vector<UpwardEdge> edges = upwardEdgesOf(polygon);
    std::vector<UpwardEdge> atHeight;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        // Only the edges that a ray of this row can cross, so that thousands of edges cost little.
        atHeight.clear();
        std::ranges::copy_if(edges, std::back_inserter(atHeight), [&](const UpwardEdge &edge) {
            return edge.crossesHeight(y * unitsPerPixel, frame.origin);
        });
        for (std::int64_t x = firstX; x < endX && !atHeight.empty(); ++x) {
            if (!isInside(atHeight, polygon.fill, frame.origin, latticePixel(x, y)))
                continue;
            *frame.at(x, y) = packed(polygon.vertices.front().colour);
        }
    }
}

} // namespace pixelplumb::oracle
