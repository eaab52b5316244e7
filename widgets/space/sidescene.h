// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/sceneprojection.h"

#include <QPoint>

namespace pixelplumb {

/// A whole scene for a view from the side, in camera coordinates.
struct SideScene {
    using Point = SpaceVector<double>;
    using Rectangle = std::array<Point, 4>; ///< lower left, lower right, upper right, upper left

    bool isPerspective = true;
    Rectangle nearPlane; ///< the part that the frame covers
    /// A plane halfway to the target, or the near plane where that is farther; the picture is drawn
    /// on it.
    Rectangle picturePlane;
    double pictureDepth = 1;
    std::vector<std::pair<Point, Point>> edges; ///< of the solids' faces
    bool showsAllEdges = true; ///< false: only of every n-th face
    std::vector<Point> outline; ///< points that enclose everything
};

SideScene sideSceneOf(const Scene &scene);

/// The current face, in camera coordinates.
struct SideFace {
    using Point = SpaceVector<double>;

    std::vector<Point> vertices;
    std::vector<Point> clipped; ///< the corners after clipping at the near plane
    std::vector<Point> picture; ///< where their rays meet the picture plane
    std::array<std::size_t, 3> piece = {}; ///< the current triangle among the corners
    std::vector<Colour> colours; ///< of the corners

    /// The current sample's ray: where it meets the picture plane and the face's plane.
    struct Ray {
        Point picture;
        Point face;
    };
    std::optional<Ray> sample;
};

/// `pixel`: the current sample.
SideFace sideFaceOf(const Scene &scene, const SideScene &side, const FaceStages &stages,
                    const TriangleSource &source, const std::optional<QPoint> &pixel);

} // namespace pixelplumb
