// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <rapidcheck.h>

#include <vector>

/// Meshes that cover their outline exactly once, built from random numbers so that RapidCheck can
/// shrink them.
namespace pixelplumb::tilings {

enum class Layout { Fan, Strip, Grid, TJunction };

using Corners = std::array<LatticePoint, 3>;

/// The triangles and the polygon around them, counter-clockwise if the area is positive.
struct Tiling {
    std::vector<Corners> triangles;
    std::vector<LatticePoint> outline;
};

/// Where the vertices of a tiling lie.
struct Place {
    Lattice grid = unitsPerPixel; ///< units between possible vertices: 256, 16 or 1
    Lattice origin = 0; ///< px, both coordinates
    Lattice cell = 8; ///< px
};

/// A random offset of at most a quarter of the cell, so that cells stay convex.
inline Lattice jitter(const Place &place)
{
    const Lattice reach = place.cell * unitsPerPixel / place.grid / 4;
    return *rc::gen::inRange<Lattice>(-reach, reach + 1) * place.grid;
}

inline LatticePoint latticeCorner(const Place &place, Lattice column, Lattice row)
{
    return {(place.origin + column * place.cell) * unitsPerPixel + jitter(place),
            (place.origin + row * place.cell) * unitsPerPixel + jitter(place)};
}

/// Cells between (side + 1)² jittered points, each cut along one of its diagonals.
inline Tiling grid(const Place &place, std::size_t side)
{
    std::vector<LatticePoint> points;
    for (std::size_t i = 0; i < (side + 1) * (side + 1); ++i)
        points.push_back(latticeCorner(place, Lattice(i % (side + 1)), Lattice(i / (side + 1))));
    const auto at
        = [&](std::size_t column, std::size_t row) { return points[row * (side + 1) + column]; };
    Tiling tiling;
    for (std::size_t row = 0; row < side; ++row) {
        for (std::size_t column = 0; column < side; ++column) {
            const LatticePoint a = at(column, row);
            const LatticePoint b = at(column + 1, row);
            const LatticePoint c = at(column + 1, row + 1);
            const LatticePoint d = at(column, row + 1);
            if (*rc::gen::arbitrary<bool>()) {
                tiling.triangles.push_back({a, b, c});
                tiling.triangles.push_back({c, d, a});
            } else {
                tiling.triangles.push_back({b, c, d});
                tiling.triangles.push_back({a, b, d});
            }
        }
    }
    for (std::size_t i = 0; i < side; ++i)
        tiling.outline.push_back(at(i, 0));
    for (std::size_t i = 0; i < side; ++i)
        tiling.outline.push_back(at(side, i));
    for (std::size_t i = side; i > 0; --i)
        tiling.outline.push_back(at(i, side));
    for (std::size_t i = side; i > 0; --i)
        tiling.outline.push_back(at(0, i));
    return tiling;
}

/// Triangles from an apex to a rim of ascending points to its right: slivers where the rim is far
/// away.
inline Tiling fan(const Place &place, std::size_t count)
{
    const LatticePoint apex = latticeCorner(place, 0, *rc::gen::inRange<Lattice>(0, 4));
    Lattice y = (place.origin - place.cell) * unitsPerPixel;
    std::vector<LatticePoint> rim;
    for (std::size_t i = 0; i < count; ++i) {
        rim.push_back({(place.origin + 3 * place.cell) * unitsPerPixel, y});
        // Steps from a single unit of the grid to half a cell.
        y += *rc::gen::inRange<Lattice>(1, place.cell * unitsPerPixel / place.grid / 2 + 2)
            * place.grid;
    }
    Tiling tiling;
    tiling.outline = {apex};
    for (std::size_t i = 0; i + 1 < count; ++i)
        tiling.triangles.push_back({rim[i + 1], apex, rim[i]});
    tiling.outline.insert(tiling.outline.end(), rim.begin(), rim.end());
    return tiling;
}

/// One row of cells, cut into triangles in a zigzag.
inline Tiling strip(const Place &place, std::size_t count)
{
    std::vector<LatticePoint> low;
    std::vector<LatticePoint> high;
    for (std::size_t i = 0; i < count; ++i) {
        low.push_back(latticeCorner(place, Lattice(i), 0));
        high.push_back(latticeCorner(place, Lattice(i), 1));
    }
    Tiling tiling;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        tiling.triangles.push_back({low[i], low[i + 1], high[i]});
        tiling.triangles.push_back({high[i], low[i + 1], high[i + 1]});
    }
    tiling.outline = low;
    tiling.outline.insert(tiling.outline.end(), high.rbegin(), high.rend());
    return tiling;
}

/// One triangle on one side of an edge, three on the other; two of their vertices lie exactly on
/// the edge, between its ends.
inline Tiling tJunction(const Place &place)
{
    const LatticePoint from = latticeCorner(place, 0, 1);
    const auto length = [&] {
        return *rc::gen::inRange<Lattice>(1, place.cell * unitsPerPixel / place.grid) * place.grid;
    };
    const LatticePoint step = {length(), length() - place.cell * unitsPerPixel / 2};
    const auto at = [&](Lattice steps) {
        return LatticePoint{from.x + steps * step.x, from.y + steps * step.y};
    };
    const Lattice first = *rc::gen::inRange<Lattice>(1, 3);
    const Lattice second = *rc::gen::inRange<Lattice>(3, 5);
    const LatticePoint above = {at(2).x, std::max(at(0).y, at(5).y) + length()};
    const LatticePoint below = {at(2).x, std::min(at(0).y, at(5).y) - length()};
    Tiling tiling;
    tiling.triangles = {{at(0), at(5), above},
                        {at(0), below, at(first)},
                        {at(first), below, at(second)},
                        {at(second), below, at(5)}};
    tiling.outline = {at(0), below, at(5), above};
    return tiling;
}

inline Tiling tiling(Layout shape, const Place &place)
{
    switch (shape) {
    case Layout::Fan:
        return fan(place, 9);
    case Layout::Strip:
        return strip(place, 5);
    case Layout::Grid:
        return grid(place, 3);
    case Layout::TJunction:
        return tJunction(place);
    }
    return {};
}

/// Whether a sample lies strictly inside the outline, by the parity of the edges that a ray to the
/// right crosses; none on the outline, whose samples belong to one side or the other.
inline std::optional<bool> isInside(const std::vector<LatticePoint> &outline, LatticePoint sample)
{
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const LatticePoint &a = outline[i];
        const LatticePoint &b = outline[(i + 1) % outline.size()];
        const Int128 side = doubledArea(a, b, sample);
        const bool withinBox = sample.x >= std::min(a.x, b.x) && sample.x <= std::max(a.x, b.x)
            && sample.y >= std::min(a.y, b.y) && sample.y <= std::max(a.y, b.y);
        if (side == 0 && withinBox)
            return std::nullopt;
        if ((a.y > sample.y) != (b.y > sample.y) && (side > 0) == (b.y > a.y))
            inside = !inside;
    }
    return inside;
}

} // namespace pixelplumb::tilings
