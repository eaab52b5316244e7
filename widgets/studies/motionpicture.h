// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPolygonF>

#include <vector>

namespace pixelplumb {

struct Scene;

/// A frame's picture with places in it, px from its top left corner.
struct MotionPicture {
    QImage image;
    std::vector<QPoint> toggled; ///< came or went since the frame before
    std::vector<QPoint> missing; ///< painted in truth, not here
    std::vector<QPolygonF> outlines; ///< of the triangles
};

/// Of a scene that moves, at a frame of its motion. What is painted is what has not the
/// background's colour.
MotionPicture motionPicture(const Scene &scene, int frame);

} // namespace pixelplumb
