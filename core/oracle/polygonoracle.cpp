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

/// Calls a function with each edge that is not horizontal.
template <class Function>
void forEachUpwardEdge(const Shape &polygon, const Function &function)
{
    forEachEdge(polygon, [&function](const LatticePoint &from, const LatticePoint &to) {
        if (from.y < to.y)
            function(UpwardEdge{from, to, 1});
        else if (from.y > to.y)
            function(UpwardEdge{to, from, -1});
    });
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

/// The edges that a sample's row crosses to its left.
class CrossedEdges {
public:
    void add(const UpwardEdge &edge, const LatticePoint &sample)
    {
        if (!edge.isLeftOf(sample))
            return;
        ++m_crossings;
        m_winding += edge.turn;
    }
    bool areAroundSample(ShapeFill fill) const
    {
        return fill == ShapeFill::NonZero ? m_winding != 0 : m_crossings % 2 != 0;
    }

private:
    std::int64_t m_crossings = 0;
    std::int64_t m_winding = 0;
};

} // namespace

bool polygonCovers(const Shape &polygon, FrameOrigin origin, std::int64_t x, std::int64_t y)
{
    if (polygon.fill == ShapeFill::Outline)
        return std::ranges::any_of(edgeLinesOf(polygon),
                                   [&](const Shape &line) { return lineCovers(line, x, y); });
    const LatticePoint sample = latticePixel(x, y);
    CrossedEdges crossed;
    forEachUpwardEdge(polygon, [&](const UpwardEdge &edge) {
        if (edge.crossesHeight(sample.y, origin))
            crossed.add(edge, sample);
    });
    return crossed.areAroundSample(polygon.fill);
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
    // A row asks only the edges that it crosses left of the frame's end, so that thousands of edges
    // cost little, and what lies beyond the frame no memory.
    std::vector<UpwardEdge> edges;
    forEachUpwardEdge(polygon, [&](const UpwardEdge &edge) {
        if (std::min(edge.low.x, edge.high.x) < endX * unitsPerPixel
            && edge.high.y >= frame.firstRow * unitsPerPixel
            && edge.low.y <= frame.endRow() * unitsPerPixel)
            edges.push_back(edge);
    });
    std::vector<UpwardEdge> atHeight;
    for (std::int64_t y = frame.firstRow; y < frame.endRow(); ++y) {
        atHeight.clear();
        std::ranges::copy_if(edges, std::back_inserter(atHeight), [&](const UpwardEdge &edge) {
            return edge.crossesHeight(y * unitsPerPixel, frame.origin);
        });
        for (std::int64_t x = firstX; x < endX && !atHeight.empty(); ++x) {
            CrossedEdges crossed;
            for (const UpwardEdge &edge : atHeight)
                crossed.add(edge, latticePixel(x, y));
            if (crossed.areAroundSample(polygon.fill))
                *frame.at(x, y) = packed(polygon.vertices.front().colour);
        }
    }
}

} // namespace pixelplumb::oracle
