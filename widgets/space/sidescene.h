// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/sceneprojection.h"

#include <QPoint>

namespace pixelplumb {

/// What a view from the side shows of a whole scene, in camera coordinates.
struct SideScene {
    using Point = SpaceVector<double>;
    using Rectangle = std::array<Point, 4>; ///< lower left, lower right, upper right, upper left

    bool isPerspective = true;
    Rectangle nearPlane; ///< the frame's part of it
    /// A plane halfway to the target, or the near plane where that is farther: what stands on it
    /// is the picture.
    Rectangle picturePlane;
    double pictureDepth = 1;
    std::vector<std::pair<Point, Point>> edges; ///< of the solids' faces
    bool showsAllEdges = true; ///< or of every so many faces
    std::vector<Point> outline; ///< points between which all of it lies
};

SideScene sideSceneOf(const Scene &scene);

/// A face in hand, in camera coordinates.
struct SideFace {
    using Point = SpaceVector<double>;

    std::vector<Point> vertices;
    std::vector<Point> clipped; ///< the corners of what the near plane leaves
    std::vector<Point> picture; ///< where their rays meet the picture plane
    std::array<std::size_t, 3> piece = {}; ///< the triangle in hand among the corners
    std::vector<Colour> colours; ///< of the corners

    /// Of the sample in hand: where its ray meets the picture plane and the face's.
    struct Ray {
        Point picture;
        Point face;
    };
    std::optional<Ray> sample;
};

/// pixel: the sample in hand.
SideFace sideFaceOf(const Scene &scene, const SideScene &side, const FaceStages &stages,
                    const TriangleSource &source, const std::optional<QPoint> &pixel);

} // namespace pixelplumb
