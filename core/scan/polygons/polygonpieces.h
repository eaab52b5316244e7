// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/polygons/triangulation.h"
#include "core/scan/polygons/polygonscan.h"

namespace pixelplumb {

inline std::array<ContourEdge, 3> edgesOf(const std::array<LatticePoint, 3> &corners)
{
    const auto &[a, b, c] = corners;
    return {{{a, b}, {b, c}, {c, a}}};
}

inline std::vector<ContourEdge> edgesOf(const Triangulation &triangulation)
{
    std::vector<ContourEdge> all;
    for (const auto &triangle : triangulation.triangles) {
        for (const ContourEdge &edge : edgesOf(triangle))
            all.push_back(edge);
    }
    return all;
}

/// Scans a polygon that is broken into triangles: the rows of one triangle after another, each
/// between its left and right edge. A sample on an edge of two triangles belongs to the one on the
/// side of its displacement, right and a little down, so none is left out or drawn twice.
template <class A, ScanObserver<PolygonNumbers<A>> Observer>
void scanTriangles(const Contours &contours, const Triangulation &triangulation, FrameView frame,
                   Observer observer)
{
    PolygonSetUp setUp = polygonSetUpFor(contours, frame.origin);
    setUp.pieceCount = triangulation.triangles.size();
    setUp.crossingCount = triangulation.crossingCount;
    setUp.largestMove = triangulation.largestMove;
    setUp.fill = ShapeFill::NonZero;
    if constexpr (readsNumbers<Observer>)
        setUp.edges = std::make_shared<const std::vector<ContourEdge>>(edgesOf(triangulation));
    observer.primitiveBegun(setUp);
    std::optional<Rejection> rejection = polygonRejection<A>(contours, frame);
    if (!rejection)
        rejection = triangulation.rejection;
    if (rejection) {
        observer.primitiveRejected(*rejection);
        return;
    }
    int piece = 0;
    for (const auto &triangle : triangulation.triangles) {
        if (doubledArea(triangle[0], triangle[1], triangle[2]) != 0)
            scanRows<A>(edgesOf(triangle), setUp, piece, frame, observer);
        ++piece;
    }
}

} // namespace pixelplumb
