// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/polygons/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>

/// The faces of a constrained triangulation that are inside under the contours' fill; shared by the
/// sources that use CGAL.
namespace pixelplumb {

enum class FaceSide { Unknown, Inside, Outside };

/// A constrained Delaunay triangulation whose faces know their side; the tag says how crossing
/// edges are treated.
template <class Kernel, class IntersectionTag>
using ConstrainedMesh = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_2<Kernel>,
        CGAL::Constrained_triangulation_face_base_2<
            Kernel, CGAL::Triangulation_face_base_with_info_2<FaceSide, Kernel>>>,
    IntersectionTag>;

template <class Mesh>
typename Mesh::Point meshPointAt(const LatticePoint &point)
{
    return {double(point.x), double(point.y)}; // exact for every lattice coordinate
}

/// The side of a point by the edges that its row crosses to its left: isCrossedLeftOf(low, high),
/// with an edge's lower and upper end, says whether it is one of them.
template <class CrossedLeftOf>
FaceSide sideBy(const Contours &contours, const CrossedLeftOf &isCrossedLeftOf)
{
    std::int64_t crossings = 0;
    std::int64_t winding = 0;
    for (const ContourEdge &edge : contours.edges) {
        const bool upward = edge.from.y < edge.to.y;
        if (!isCrossedLeftOf(upward ? edge.from : edge.to, upward ? edge.to : edge.from))
            continue;
        ++crossings;
        winding += upward ? 1 : -1;
    }
    const bool isInside = contours.fill == ShapeFill::NonZero ? winding != 0 : crossings % 2 != 0;
    return isInside ? FaceSide::Inside : FaceSide::Outside;
}

/// Marks a face and all faces reachable from it without crossing a contour.
template <class Mesh>
void spreadSide(const Mesh &mesh, typename Mesh::Face_handle start, FaceSide side)
{
    std::vector<typename Mesh::Face_handle> waiting = {start};
    start->info() = side;
    while (!waiting.empty()) {
        const auto face = waiting.back();
        waiting.pop_back();
        for (int edge = 0; edge < 3; ++edge) {
            const auto next = face->neighbor(edge);
            if (face->is_constrained(edge) || mesh.is_infinite(next)
                || next->info() != FaceSide::Unknown)
                continue;
            next->info() = side;
            waiting.push_back(next);
        }
    }
}

/// The triangles of the inside faces, counter-clockwise from their smallest corner, in ascending
/// order. sideOf(face) gives a face's side, cornerOf(face, corner) a corner.
template <class Mesh, class SideOf, class CornerOf>
std::vector<std::array<LatticePoint, 3>> insideTriangles(const Mesh &mesh, const SideOf &sideOf,
                                                         const CornerOf &cornerOf)
{
    std::vector<std::array<LatticePoint, 3>> triangles;
    for (const auto face : mesh.finite_face_handles())
        face->info() = FaceSide::Unknown;
    for (const auto face : mesh.finite_face_handles()) {
        if (face->info() == FaceSide::Unknown)
            spreadSide(mesh, face, sideOf(face));
        if (face->info() != FaceSide::Inside)
            continue;
        std::array<LatticePoint, 3> corners
            = {cornerOf(face, 0), cornerOf(face, 1), cornerOf(face, 2)};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        triangles.push_back(corners);
    }
    std::ranges::sort(triangles);
    return triangles;
}

} // namespace pixelplumb
