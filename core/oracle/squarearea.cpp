// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/squarearea.h"

#include <algorithm>
#include <vector>

namespace pixelplumb::oracle {

namespace {

/// Lattice units from the square's centre; the square extends from −halfPixel to halfPixel.
using RationalPoint = std::array<BigRational, 2>;

std::array<LatticePoint, 3> cornersFrom(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const LatticePoint centre = latticePixel(x, y);
    std::array<LatticePoint, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticePoint &position = triangle.vertices[i].position;
        corners[i] = {position.x - centre.x, position.y - centre.y};
    }
    return corners;
}

/// On which sides of the line from a to b the square's corners lie.
struct SquareSides {
    bool left = false;
    bool right = false;
    bool on = false;
};

SquareSides sidesOf(const LatticePoint &a, const LatticePoint &b)
{
    SquareSides sides;
    for (const Lattice x : {-halfPixel, halfPixel}) {
        for (const Lattice y : {-halfPixel, halfPixel}) {
            const Int128 turn = doubledArea(a, b, {x, y});
            sides.left = sides.left || turn > 0;
            sides.right = sides.right || turn < 0;
            sides.on = sides.on || turn == 0;
        }
    }
    return sides;
}

/// The part of the polygon with sign·coordinate <= halfPixel.
std::vector<RationalPoint> clipped(const std::vector<RationalPoint> &polygon, std::size_t axis,
                                   int sign)
{
    const auto excess
        = [&](const RationalPoint &point) { return BigRational(sign * point[axis] - halfPixel); };
    std::vector<RationalPoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const RationalPoint &from = polygon[i];
        const RationalPoint &to = polygon[(i + 1) % polygon.size()];
        const BigRational before = excess(from);
        const BigRational after = excess(to);
        if (before <= 0)
            kept.push_back(from);
        if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
            const BigRational way = before / (before - after);
            kept.push_back({from[0] + way * (to[0] - from[0]), from[1] + way * (to[1] - from[1])});
        }
    }
    return kept;
}

BigRational areaOf(const std::vector<RationalPoint> &polygon)
{
    BigRational doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const RationalPoint &a = polygon[i];
        const RationalPoint &b = polygon[(i + 1) % polygon.size()];
        doubled += a[0] * b[1] - b[0] * a[1];
    }
    return abs(doubled) / 2;
}

bool segmentMeetsSquare(const LatticePoint &a, const LatticePoint &b)
{
    const auto isBeside = [](Lattice first, Lattice second) {
        return std::max(first, second) < -halfPixel || std::min(first, second) > halfPixel;
    };
    if (isBeside(a.x, b.x) || isBeside(a.y, b.y))
        return false;
    const SquareSides sides = sidesOf(a, b);
    return sides.on || (sides.left && sides.right);
}

} // namespace

BigRational areaInSquare(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    std::array<LatticePoint, 3> corners = cornersFrom(triangle, x, y);
    const Int128 turn = doubledArea(corners[0], corners[1], corners[2]);
    if (turn == 0)
        return 0;
    if (turn < 0)
        std::swap(corners[1], corners[2]);
    bool holdsSquare = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const SquareSides sides = sidesOf(corners[i], corners[(i + 1) % 3]);
        if (!sides.left)
            return 0;
        holdsSquare = holdsSquare && !sides.right;
    }
    if (holdsSquare)
        return 1;
    std::vector<RationalPoint> polygon;
    polygon.reserve(corners.size());
    for (const LatticePoint &corner : corners)
        polygon.push_back({BigRational(corner.x), BigRational(corner.y)});
    for (const std::size_t axis : {0, 1}) {
        for (const int sign : {-1, 1})
            polygon = clipped(polygon, axis, sign);
    }
    return areaOf(polygon) / (unitsPerPixel * unitsPerPixel);
}

bool edgeMeetsSquare(const Triangle &triangle, std::int64_t x, std::int64_t y)
{
    const std::array<LatticePoint, 3> corners = cornersFrom(triangle, x, y);
    return segmentMeetsSquare(corners[0], corners[1]) || segmentMeetsSquare(corners[1], corners[2])
        || segmentMeetsSquare(corners[2], corners[0]);
}

} // namespace pixelplumb::oracle
