// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/insidefaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace pixelplumb {

namespace {

// A double holds every lattice coordinate, and the predicates are exact. No point is ever
// constructed: the library throws an exception for edges that cross between vertices.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = ConstrainedMesh<Kernel, CGAL::No_constraint_intersection_requiring_constructions_tag>;

LatticePoint cornerOf(const Mesh::Face_handle &face, int corner)
{
    const Kernel::Point_2 &point = face->vertex(corner)->point();
    return {Lattice(point.x()), Lattice(point.y())};
}

/// Whether a triangle that no edge enters is inside, by the crossings to the left of its centre;
/// the centre's coordinates are multiples of a third of a lattice unit.
FaceSide sideOf(const Contours &contours, const Mesh::Face_handle &face)
{
    LatticePoint centre; // times 3
    for (int corner = 0; corner < 3; ++corner) {
        centre.x += cornerOf(face, corner).x;
        centre.y += cornerOf(face, corner).y;
    }
    return sideBy(contours, [&centre](const LatticePoint &low, const LatticePoint &high) {
        return centre.y >= 3 * low.y && centre.y < 3 * high.y
            && Int128(high.y - low.y) * (centre.x - 3 * low.x)
            >= Int128(high.x - low.x) * (centre.y - 3 * low.y);
    });
}

/// Whether the interiors of two edges cross.
bool cross(const ContourEdge &a, const ContourEdge &b)
{
    const auto parts = [](const ContourEdge &edge, const LatticePoint &p, const LatticePoint &q) {
        const Int128 left = doubledArea(edge.from, edge.to, p);
        const Int128 right = doubledArea(edge.from, edge.to, q);
        return (left < 0 && right > 0) || (left > 0 && right < 0);
    };
    return parts(a, b.from, b.to) && parts(b, a.from, a.to);
}

/// The index of an edge's end: the next vertex, or its contour's first one.
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

/// The ends of the first edge that crosses edge `later`, then the ends of `later`.
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
    std::vector<Kernel::Point_2> points;
    points.reserve(contours.edges.size());
    for (const ContourEdge &edge : contours.edges)
        points.push_back(meshPointAt<Mesh>(edge.from));
    mesh.insert(points.begin(), points.end());
    std::size_t inserted = 0;
    try {
        for (; inserted < contours.edges.size(); ++inserted) {
            const ContourEdge &edge = contours.edges[inserted];
            if (edge.from != edge.to)
                mesh.insert_constraint(meshPointAt<Mesh>(edge.from), meshPointAt<Mesh>(edge.to));
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
    triangulation.triangles = insideTriangles(
        mesh, [&](const Mesh::Face_handle &face) { return sideOf(contours, face); }, cornerOf);
    return triangulation;
}

} // namespace pixelplumb
