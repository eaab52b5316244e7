// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/triangulation.h"

namespace pixelplumb {

namespace {

/// The indices of the contours' vertices, one for each run of equal neighbours.
std::vector<std::size_t> distinctVertices(const Contours &contours)
{
    std::vector<std::size_t> vertices;
    for (std::size_t i = 0; i < contours.edges.size(); ++i) {
        if (contours.edges[i].from != contours.edges[i].to)
            vertices.push_back(i);
    }
    return vertices;
}

std::vector<LatticePoint> positionsOf(const Contours &contours,
                                      const std::vector<std::size_t> &vertices)
{
    std::vector<LatticePoint> positions;
    positions.reserve(vertices.size());
    for (const std::size_t vertex : vertices)
        positions.push_back(contours.edges[vertex].from);
    return positions;
}

/// Twice the signed area: positive for a counter-clockwise contour.
Int128 areaOf(const std::vector<LatticePoint> &vertices)
{
    Int128 area = 0;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        area += doubledArea(vertices[0], vertices[i], vertices[i + 1]);
    return area;
}

int signOf(Int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The first vertex where the contour turns the wrong way, or straight back.
std::optional<std::size_t> wrongTurn(const std::vector<LatticePoint> &vertices)
{
    int turn = signOf(areaOf(vertices));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const LatticePoint &a = vertices[i];
        const LatticePoint &b = vertices[(i + 1) % vertices.size()];
        const LatticePoint &c = vertices[(i + 2) % vertices.size()];
        const int here = signOf(doubledArea(a, b, c));
        const bool goesBack
            = here == 0 && Int128(b.x - a.x) * (c.x - b.x) + Int128(b.y - a.y) * (c.y - b.y) < 0;
        if (goesBack || (here != 0 && turn != 0 && here != turn))
            return (i + 1) % vertices.size();
        if (here != 0)
            turn = here;
    }
    return std::nullopt;
}

/// A contour that turns one way goes round once if it changes twice between leftward and rightward.
/// A pentagram turns one way but goes round twice.
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
    const std::vector<std::size_t> numbers = distinctVertices(contours);
    const std::vector<LatticePoint> vertices = positionsOf(contours, numbers);
    if (boxAround(contours.edges).isFlat()) {
        fan.rejection = PrimitiveRejection::ZeroArea;
        return fan;
    }
    if (contours.count != 1) {
        fan.rejection = PrimitiveRejection::NotConvex;
        return fan;
    }
    if (const auto turn = wrongTurn(vertices)) {
        fan.rejection = Rejection(PrimitiveRejection::NotConvex, {numbers[*turn]});
        return fan;
    }
    if (!goesRoundOnce(vertices)) {
        fan.rejection = PrimitiveRejection::NotConvex;
        return fan;
    }
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        fan.triangles.push_back({vertices[0], vertices[i], vertices[i + 1]});
    return fan;
}

} // namespace pixelplumb
