// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/geometry/trianglesource.h"
#include "core/number/jobprogress.h"
#include "core/space/faceprojector.h"

namespace pixelplumb {

/// Why a face, or one of its triangles, is not drawn.
enum class ProjectionLoss : std::uint8_t {
    NoView, ///< the camera's eye is at its target, or up is parallel to the view direction
    BehindNearPlane, ///< the whole face, or all but a corner or edge in the plane
    NotFinite, ///< a position in the frame that is NaN or infinite
    OutsideCoordinates, ///< beyond ±2^30 px
    OutsideAttributes, ///< z, u, v or a position in space beyond ±2^20
};

/// "has no part beyond the near plane": completes a sentence that begins with the face.
QString nameOf(ProjectionLoss loss);

struct LostTriangle {
    TriangleSource source;
    ProjectionLoss loss = ProjectionLoss::BehindNearPlane;

    friend bool operator==(const LostTriangle &, const LostTriangle &) = default;
};

/// The solids as triangles in sample coordinates, in drawing order: solid by solid, face by face,
/// piece by piece. Back faces are drawn too.
struct ProjectedSolids {
    std::vector<Triangle> triangles;
    std::vector<TriangleAttributes> attributes; ///< one for each triangle
    std::vector<TriangleSource> sources; ///< one for each triangle
    std::vector<LostTriangle> lost;
    std::vector<std::size_t> cutAtNear; ///< triangles of faces that the near plane cuts; ascending
    /// w is the view depth times 2^wExponent (see wExponentOf).
    int wExponent = 0;
};

/// Projects the solids; none where the listener ended it. The listener hears now and then how many
/// faces are projected.
std::optional<ProjectedSolids> projectSolids(const SpaceScene &scene,
                                             const ProgressListener &listener = {});

/// The power of two that scales all w of a scene; only ratios of w matter. It is 0 where every
/// depth lies between 1 and 2^20; otherwise the largest depth fits and, if there is room, the near
/// plane's w is at least 1.
int wExponentOf(const SpaceScene &scene);

/// A corner as the kernels get it.
struct SnappedCorner {
    Vertex vertex;
    VertexAttributes attributes;
    std::optional<ProjectionLoss> loss; ///< set where the formats cannot represent the corner
};

SnappedCorner snapped(const ClippedCorner<double> &corner, const std::array<double, 2> &place,
                      double z, int wExponent);

/// The appearance with the camera as viewer: its eye, or the direction towards it.
Appearance viewedBy(const Camera &camera, Appearance appearance);

} // namespace pixelplumb
