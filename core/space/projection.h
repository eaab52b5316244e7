// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/geometry/trianglesource.h"
#include "core/number/jobprogress.h"
#include "core/space/faceprojector.h"

namespace pixelplumb {

/// Why a face, or a triangle of it, is not drawn.
enum class ProjectionLoss : std::uint8_t {
    NoView, ///< the camera's eye is at its target, or up is the direction in which it looks
    BehindNearPlane, ///< all of the face, or all but a corner or an edge that lies in the plane
    NotFinite, ///< a place in the frame that is no number
    OutsideCoordinates, ///< beyond ±2^30 px
    OutsideAttributes, ///< z, u, v or a place in space beyond ±2^20
};

/// "has no part beyond the near plane": the rest of a sentence that begins with the face.
QString nameOf(ProjectionLoss loss);

struct LostTriangle {
    TriangleSource source;
    ProjectionLoss loss = ProjectionLoss::BehindNearPlane;

    friend bool operator==(const LostTriangle &, const LostTriangle &) = default;
};

/// The solids as triangles in sample coordinates, in drawing order: solid by solid, face by face,
/// piece by piece. Faces that turn their backs are drawn as well.
struct ProjectedSolids {
    std::vector<Triangle> triangles;
    std::vector<TriangleAttributes> attributes; ///< of each of them
    std::vector<TriangleSource> sources; ///< of each of them
    std::vector<LostTriangle> lost;
    std::vector<std::size_t> cutAtNear; ///< triangles of a face that the near plane cuts; ascending
    /// w is the view depth times 2^wExponent (see wExponentOf).
    int wExponent = 0;
};

/// None where the listener, who hears now and then how many faces are projected, ended it.
std::optional<ProjectedSolids> projectSolids(const SpaceScene &scene,
                                             const ProgressListener &listener = {});

/// The power of two by which w is written for all of a scene, since only ratios of w count: 0 where
/// every depth lies between 1 and 2^20; otherwise such that the largest fits, and, where that
/// leaves room, the near plane's is at least 1.
int wExponentOf(const SpaceScene &scene);

/// A corner as kernels get it.
struct SnappedCorner {
    Vertex vertex;
    VertexAttributes attributes;
    std::optional<ProjectionLoss> loss; ///< where it cannot be told in their formats
};

SnappedCorner snapped(const ClippedCorner<double> &corner, const std::array<double, 2> &place,
                      double z, int wExponent);

/// The appearance with the viewer that a camera is: its eye, or the direction towards it.
Appearance viewedBy(const Camera &camera, Appearance appearance);

} // namespace pixelplumb
