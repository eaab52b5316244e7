// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/polygons/insidefaces.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>

namespace pixelplumb {

namespace {

// Crossings are constructed as exact fractions.
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CrossingMesh = ConstrainedMesh<ExactKernel, CGAL::Exact_intersections_tag>;
using Fraction = ExactKernel::FT;

/// The nearest whole number; ties go up.
Lattice nearestTo(const Fraction &value)
{
    Lattice nearest = std::llround(CGAL::to_double(value));
    // llround() is right only to a double's last place.
    while (2 * value < 2 * double(nearest) - 1)
        --nearest;
    while (2 * value >= 2 * double(nearest) + 1)
        ++nearest;
    return nearest;
}

LatticePoint nearestTo(const ExactKernel::Point_2 &point)
{
    return {nearestTo(point.x()), nearestTo(point.y())};
}

/// A point's distance to its nearest lattice point, lattice units.
double displacementOf(const ExactKernel::Point_2 &point)
{
    return std::hypot(CGAL::to_double(point.x() - double(nearestTo(point.x()))),
                      CGAL::to_double(point.y() - double(nearestTo(point.y()))));
}

FaceSide sideOf(const Contours &contours, const CrossingMesh::Face_handle &face)
{
    const ExactKernel::Point_2 centre = CGAL::centroid(
        face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
    return sideBy(contours, [&](const LatticePoint &low, const LatticePoint &high) {
        return centre.y() >= double(low.y) && centre.y() < double(high.y)
            && CGAL::orientation(meshPointAt<CrossingMesh>(low), meshPointAt<CrossingMesh>(high),
                                 centre)
            != CGAL::LEFT_TURN;
    });
}

/// Counts the mesh vertices that are not vertices of the contours, and measures how far they move.
void measureCrossings(const CrossingMesh &mesh, const Contours &contours,
                      Triangulation &triangulation)
{
    std::vector<LatticePoint> given;
    for (const ContourEdge &edge : contours.edges)
        given.push_back(edge.from);
    std::ranges::sort(given);
    for (const auto vertex : mesh.finite_vertex_handles()) {
        const double moved = displacementOf(vertex->point());
        if (moved == 0 && std::ranges::binary_search(given, nearestTo(vertex->point())))
            continue;
        ++triangulation.crossingCount;
        triangulation.largestMove
            = std::max(triangulation.largestMove, moved / double(unitsPerPixel));
    }
}

} // namespace

Triangulation tessellationOf(const Contours &contours)
{
    Triangulation triangulation;
    CrossingMesh mesh;
    for (const ContourEdge &edge : contours.edges) {
        if (edge.from != edge.to)
            mesh.insert_constraint(meshPointAt<CrossingMesh>(edge.from),
                                   meshPointAt<CrossingMesh>(edge.to));
    }
    if (mesh.dimension() < 2) {
        triangulation.rejection = PrimitiveRejection::ZeroArea;
        return triangulation;
    }
    measureCrossings(mesh, contours, triangulation);
    triangulation.triangles = insideTriangles(
        mesh, [&](const CrossingMesh::Face_handle &face) { return sideOf(contours, face); },
        [](const CrossingMesh::Face_handle &face, int corner) {
            return nearestTo(face->vertex(corner)->point());
        });
    return triangulation;
}

} // namespace pixelplumb
