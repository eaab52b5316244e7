// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/polygons/contours.h"

#include <array>
#include <optional>

namespace pixelplumb {

/// A polygon broken into triangles whose corners are vertices of the polygon, or crossings of its
/// edges (Scan Conversion slides, "From Polygons to Triangles"; Rasterization slides,
/// "Triangulation"). They tile what the polygon covers; some may have no area.
struct Triangulation {
    std::vector<std::array<LatticePoint, 3>> triangles;
    std::size_t crossingCount = 0; ///< corners where edges cross: vertices of no contour
    double largestMove = 0; ///< the farthest that one of these was moved onto the lattice, px
    std::optional<Rejection> rejection; ///< then there are no triangles
};

/// The triangles from the first vertex to each edge that does not touch it. Only of a polygon of
/// one contour that turns one way and goes round once; collinear vertices may be among its own.
Triangulation fanOf(const Contours &contours);

/// The constrained Delaunay triangulation of the contours: every edge of theirs is an edge of it,
/// and otherwise no vertex lies in the circle around a triangle from which it can be seen. Of its
/// triangles those that are inside under the contours' fill. Contours may be concave, lie within
/// one another, touch and overlap; where two edges cross between vertices, the polygon is rejected,
/// because the crossing is no lattice point and no vertex can stand there.
/// The triangles go counter-clockwise from their smallest corner, in ascending order, so that they
/// are the same in every version of the library that makes them.
Triangulation delaunayOf(const Contours &contours);

/// The same of any contours: where edges cross, the crossing becomes a vertex, first as an exact
/// fraction, by which the triangles are found, and then the nearest point of the lattice, at most
/// √2/512 px away (both to a half up). That tilts the edges that meet there: a sample nearer to one
/// than that may change its side, so that the triangles cover what the polygon covers but for such
/// samples.
Triangulation tessellationOf(const Contours &contours);

} // namespace pixelplumb
