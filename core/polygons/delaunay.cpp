// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <algorithm>

namespace pixelplumb {

namespace {

// A double holds every lattice coordinate, and the predicates are exact. No point is ever
// constructed: edges that cross between vertices are refused by the library with an exception.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

enum class Side { Unknown, Inside, Outside };

using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Side, Kernel>>;
using Mesh = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

LatticePoint cornerOf(const Mesh::Face_handle &face, int corner)
{
    const Kernel::Point_2 &point = face->vertex(corner)->point();
    return {Lattice(point.x()), Lattice(point.y())};
}

/// Whether a triangle that no edge enters is inside: by the crossings to the left of its centre,
/// whose coordinates are whole numbers of thirds of a lattice unit.
Side sideOf(const Contours &contours, const Mesh::Face_handle &face)
{
    LatticePoint centre; // times 3
    for (int corner = 0; corner < 3; ++corner) {
        centre.x += cornerOf(face, corner).x;
        centre.y += cornerOf(face, corner).y;
    }
    std::int64_t crossings = 0;
    std::int64_t winding = 0;
    for (const ContourEdge &edge : contours.edges) {
        const bool upward = edge.from.y < edge.to.y;
        const LatticePoint &low = upward ? edge.from : edge.to;
        const LatticePoint &high = upward ? edge.to : edge.from;
        if (centre.y < 3 * low.y || centre.y >= 3 * high.y)
            continue;
        const Int128 rightOf = Int128(high.y - low.y) * (centre.x - 3 * low.x)
            - Int128(high.x - low.x) * (centre.y - 3 * low.y);
        if (rightOf < 0)
            continue;
        ++crossings;
        winding += upward ? 1 : -1;
    }
    const bool isInside = contours.fill == ShapeFill::NonZero ? winding != 0 : crossings % 2 != 0;
    return isInside ? Side::Inside : Side::Outside;
}

/// Marks a face and all that can be reached from it without crossing a contour.
void spread(const Mesh &mesh, const Mesh::Face_handle &start, Side side)
{
    std::vector<Mesh::Face_handle> waiting = {start};
    start->info() = side;
    while (!waiting.empty()) {
        const Mesh::Face_handle face = waiting.back();
        waiting.pop_back();
        for (int edge = 0; edge < 3; ++edge) {
            const Mesh::Face_handle next = face->neighbor(edge);
            if (face->is_constrained(edge) || mesh.is_infinite(next)
                || next->info() != Side::Unknown)
                continue;
            next->info() = side;
            waiting.push_back(next);
        }
    }
}

/// Whether the inner parts of two edges cross.
bool cross(const ContourEdge &a, const ContourEdge &b)
{
    const auto parts = [](const ContourEdge &edge, const LatticePoint &p, const LatticePoint &q) {
        const Int128 left = doubledArea(edge.from, edge.to, p);
        const Int128 right = doubledArea(edge.from, edge.to, q);
        return (left < 0 && right > 0) || (left > 0 && right < 0);
    };
    return parts(a, b.from, b.to) && parts(b, a.from, a.to);
}

/// Where an edge ends: the next vertex, or its contour's first one.
std::size_t endOf(const Contours &contours, std::size_t edge)
{
    const LatticePoint &end = contours.edges[edge].to;
    if (edge + 1 < contours.edges.size() && contours.edges[edge + 1].from == end)
        return edge + 1;
    std::size_t first = edge;
    while (first > 0 && contours.edges[first - 1].to == contours.edges[first].from)
        --first;
    return first;
}

/// The ends of the first edge that crosses a later one, and of that.
std::vector<std::size_t> crossingBefore(const Contours &contours, std::size_t later)
{
    for (std::size_t edge = 0; edge < later; ++edge) {
        if (cross(contours.edges[edge], contours.edges[later]))
            return {edge, endOf(contours, edge), later, endOf(contours, later)};
    }
    return {};
}

} // namespace

Triangulation delaunayOf(const Contours &contours)
{
    Triangulation triangulation;
    Mesh mesh;
    const auto pointAt = [](const LatticePoint &point) {
        return Kernel::Point_2(double(point.x), double(point.y));
    };
    std::vector<Kernel::Point_2> points;
    points.reserve(contours.edges.size());
    for (const ContourEdge &edge : contours.edges)
        points.push_back(pointAt(edge.from));
    mesh.insert(points.begin(), points.end());
    std::size_t inserted = 0;
    try {
        for (; inserted < contours.edges.size(); ++inserted) {
            const ContourEdge &edge = contours.edges[inserted];
            if (edge.from != edge.to)
                mesh.insert_constraint(pointAt(edge.from), pointAt(edge.to));
        }
    } catch (const Mesh::Intersection_of_constraints_exception &) {
        triangulation.rejection
            = Rejection(PrimitiveRejection::SelfCrossing, crossingBefore(contours, inserted));
        return triangulation;
    }
    if (mesh.dimension() < 2) {
        triangulation.rejection = PrimitiveRejection::ZeroArea;
        return triangulation;
    }
    for (const Mesh::Face_handle face : mesh.finite_face_handles())
        face->info() = Side::Unknown;
    for (const Mesh::Face_handle face : mesh.finite_face_handles()) {
        if (face->info() == Side::Unknown)
            spread(mesh, face, sideOf(contours, face));
        if (face->info() != Side::Inside)
            continue;
        std::array<LatticePoint, 3> corners
            = {cornerOf(face, 0), cornerOf(face, 1), cornerOf(face, 2)};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        triangulation.triangles.push_back(corners);
    }
    std::ranges::sort(triangulation.triangles);
    return triangulation;
}

} // namespace pixelplumb
