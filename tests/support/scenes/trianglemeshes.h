// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <algorithm>
#include <random>
#include <vector>

/// Meshes that fill a rectangle, for tests of which triangle owns the samples on shared edges.
namespace pixelplumb {

struct TriangleMesh {
    std::vector<Triangle> triangles;
    LatticePoint lowest, highest; ///< corners of the rectangle

    void add(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
    {
        const Colour colour = {{200, 100, 50}};
        // Every other triangle has the opposite winding.
        if (triangles.size() % 2 == 0)
            triangles.push_back({{{{a, colour}, {b, colour}, {c, colour}}}});
        else
            triangles.push_back({{{{b, colour}, {a, colour}, {c, colour}}}});
    }
};

/// The position of a mesh and the step of its lattice.
struct MeshPlace {
    LatticePoint origin;
    Lattice step = unitsPerPixel; ///< vertices are at origin + whole steps
    Lattice side = 24 * unitsPerPixel; ///< of the rectangle
};

class MeshMaker {
public:
    MeshMaker(const MeshPlace &place, std::uint64_t seed)
        : m_place(place)
        , m_random(seed)
    {
    }

    /// A grid with cells of about 6 px, inner corners moved at random, and either diagonal.
    TriangleMesh grid()
    {
        TriangleMesh mesh = empty();
        constexpr int cells = 4;
        std::array<std::array<LatticePoint, cells + 1>, cells + 1> points;
        for (int row = 0; row <= cells; ++row) {
            for (int column = 0; column <= cells; ++column) {
                const bool isInner = row > 0 && row < cells && column > 0 && column < cells;
                const Lattice reach = isInner ? m_place.side / cells / 3 : 0;
                points[std::size_t(row)][std::size_t(column)]
                    = at(column * m_place.side / cells + jitter(reach),
                         row * m_place.side / cells + jitter(reach));
            }
        }
        for (std::size_t row = 0; row < cells; ++row) {
            for (std::size_t column = 0; column < cells; ++column) {
                const LatticePoint &a = points[row][column], &b = points[row][column + 1];
                const LatticePoint &c = points[row + 1][column + 1], &d = points[row + 1][column];
                if (jitter(8) % 2 == 0) {
                    mesh.add(a, b, c);
                    mesh.add(a, c, d);
                } else {
                    mesh.add(a, b, d);
                    mesh.add(b, c, d);
                }
            }
        }
        return mesh;
    }

    /// Slivers around one point, reaching points all along the border.
    TriangleMesh fan()
    {
        TriangleMesh mesh = empty();
        const LatticePoint centre = at(m_place.side / 2 + jitter(m_place.side / 3),
                                       m_place.side / 2 + jitter(m_place.side / 3));
        std::vector<Lattice> stops = cuts(6);
        std::vector<LatticePoint> border;
        const Lattice side = m_place.side;
        for (const Lattice stop : stops)
            border.push_back(at(stop, 0));
        for (const Lattice stop : stops)
            border.push_back(at(side, stop));
        for (const Lattice stop : stops)
            border.push_back(at(side - stop, side));
        for (const Lattice stop : stops)
            border.push_back(at(0, side - stop));
        for (std::size_t i = 0; i < border.size(); ++i) {
            if (border[i] != border[(i + 1) % border.size()])
                mesh.add(centre, border[i], border[(i + 1) % border.size()]);
        }
        return mesh;
    }

    /// A strip between the lower and the upper border.
    TriangleMesh strip()
    {
        TriangleMesh mesh = empty();
        const std::vector<Lattice> low = withEnd(cuts(9)), high = withEnd(cuts(9));
        for (std::size_t i = 0; i + 1 < low.size(); ++i) {
            mesh.add(at(low[i], 0), at(low[i + 1], 0), at(high[i], m_place.side));
            mesh.add(at(high[i], m_place.side), at(high[i + 1], m_place.side), at(low[i + 1], 0));
        }
        return mesh;
    }

    /// T-junctions along the diagonal: one triangle on one side meets many on the other, whose
    /// vertices lie exactly on it.
    TriangleMesh junctions()
    {
        TriangleMesh mesh = empty();
        const std::vector<Lattice> stops = withEnd(cuts(7));
        mesh.add(at(0, 0), at(m_place.side, 0), at(m_place.side, m_place.side));
        for (std::size_t i = 0; i + 1 < stops.size(); ++i)
            mesh.add(at(stops[i], stops[i]), at(stops[i + 1], stops[i + 1]), at(0, m_place.side));
        return mesh;
    }

    std::vector<TriangleMesh> all() { return {grid(), fan(), strip(), junctions()}; }

private:
    TriangleMesh empty() const { return {{}, at(0, 0), at(m_place.side, m_place.side)}; }

    LatticePoint at(Lattice x, Lattice y) const
    {
        const auto snapped
            = [this](Lattice offset) { return floorDivide(offset, m_place.step) * m_place.step; };
        return {m_place.origin.x + snapped(x), m_place.origin.y + snapped(y)};
    }
    Lattice jitter(Lattice reach)
    {
        return std::uniform_int_distribution<Lattice>(-reach, reach)(m_random);
    }
    /// 0 and `count` random positions above it, ascending, each a whole number of steps.
    std::vector<Lattice> cuts(int count)
    {
        std::vector<Lattice> places = {0};
        std::uniform_int_distribution<Lattice> within(1, m_place.side / m_place.step - 1);
        for (int i = 0; i < count; ++i)
            places.push_back(within(m_random) * m_place.step);
        std::ranges::sort(places);
        return places;
    }
    std::vector<Lattice> withEnd(std::vector<Lattice> places) const
    {
        places.push_back(m_place.side);
        return places;
    }

    MeshPlace m_place;
    std::mt19937_64 m_random;
};

} // namespace pixelplumb
