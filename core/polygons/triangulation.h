// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/polygons/contours.h"

#include <array>
#include <optional>

namespace pixelplumb {

/// A polygon split into triangles whose corners are its vertices or crossings of its edges (Scan
/// Conversion slides, "From Polygons to Triangles"; Rasterization slides, "Triangulation"). The
/// triangles tile what the polygon covers; some may have no area.
struct Triangulation {
    std::vector<std::array<LatticePoint, 3>> triangles;
    std::size_t crossingCount = 0; ///< corners where edges cross, not vertices of a contour
    double largestMove = 0; ///< the farthest that a crossing was moved onto the lattice, px
    std::optional<Rejection> rejection; ///< if set, there are no triangles
};

/// The triangles from the first vertex to each edge that does not touch it. Requires one contour
/// that turns one way and goes round once; collinear vertices are allowed.
Triangulation fanOf(const Contours &contours);

/// The constrained Delaunay triangulation of the contours, reduced to the triangles that are inside
/// under their fill: every contour edge is an edge of it, and otherwise no vertex lies in the
/// circumcircle of a triangle from which it is visible. Contours may be concave, nest, touch and
/// overlap; where two edges cross between vertices, the polygon is rejected, because the crossing
/// is no lattice point and no vertex can stand there.
/// The triangles run counter-clockwise from their smallest corner, in ascending order, so that they
/// are the same in every version of the library that makes them.
Triangulation delaunayOf(const Contours &contours);

/// Like delaunayOf(), but for any contours. A crossing of edges becomes a vertex: first an exact
/// fraction, which determines the triangles, then the nearest lattice point, at most √2/512 px away
/// (ties go up on both axes). This tilts the edges that meet there: a sample closer than that to
/// one of them may change its side; otherwise the triangles cover what the polygon covers.
Triangulation tessellationOf(const Contours &contours);

} // namespace pixelplumb
