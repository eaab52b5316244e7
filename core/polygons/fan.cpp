// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/triangulation.h"

namespace pixelplumb {

namespace {

/// The vertices of the first contour, each once where several follow one another in one place.
std::vector<LatticePoint> distinctVertices(const Contours &contours)
{
    std::vector<LatticePoint> vertices;
    for (const ContourEdge &edge : contours.edges) {
        if (edge.from != edge.to)
            vertices.push_back(edge.from);
    }
    return vertices;
}

int signOf(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Where the contour turns both ways, or back, it is not convex.
bool turnsOneWay(const std::vector<LatticePoint> &vertices)
{
    int turn = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const LatticePoint &a = vertices[i];
        const LatticePoint &b = vertices[(i + 1) % vertices.size()];
        const LatticePoint &c = vertices[(i + 2) % vertices.size()];
        const int here = signOf(doubledArea(a, b, c));
        const bool goesBack
            = here == 0 && Int128(b.x - a.x) * (c.x - b.x) + Int128(b.y - a.y) * (c.y - b.y) < 0;
        if (goesBack || (here != 0 && turn != 0 && here != turn))
            return false;
        if (here != 0)
            turn = here;
    }
    return true;
}

/// A contour that turns one way goes round once if it changes between leftward and rightward twice.
/// A pentagram turns one way and goes round two times.
bool goesRoundOnce(const std::vector<LatticePoint> &vertices)
{
    int first = 0;
    int last = 0;
    int changes = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const int direction = signOf(vertices[(i + 1) % vertices.size()].x - vertices[i].x);
        if (direction == 0)
            continue;
        changes += int(last != 0 && direction != last);
        last = direction;
        if (first == 0)
            first = direction;
    }
    return changes + int(first != last) <= 2;
}

} // namespace

Triangulation fanOf(const Contours &contours)
{
    Triangulation fan;
    const std::vector<LatticePoint> vertices = distinctVertices(contours);
    if (boxAround(contours.edges).isFlat()) {
        fan.rejection = PrimitiveRejection::ZeroArea;
        return fan;
    }
    if (contours.count != 1 || !turnsOneWay(vertices) || !goesRoundOnce(vertices)) {
        fan.rejection = PrimitiveRejection::NotConvex;
        return fan;
    }
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        fan.triangles.push_back({vertices[0], vertices[i], vertices[i + 1]});
    return fan;
}

} // namespace pixelplumb
