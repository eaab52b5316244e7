// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPolygonF>

#include <vector>

namespace pixelplumb {

struct Scene;

/// A frame's picture with marked places, px from its top left corner.
struct MotionPicture {
    QImage image;
    std::vector<QPoint> toggled; ///< came or went since the frame before
    std::vector<QPoint> missing; ///< painted in truth, not here
    std::vector<QPolygonF> outlines; ///< of the triangles
};

/// The picture of a moving scene at a frame of its motion. A pixel is painted if it does not have
/// the background's colour.
MotionPicture motionPicture(const Scene &scene, int frame);

} // namespace pixelplumb
