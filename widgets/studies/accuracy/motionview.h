// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/geometry/lattice.h"

#include <QtWidgets>

#include <array>
#include <vector>

namespace pixelplumb {

struct Scene;

/// A frame's picture with marked pixels.
struct MotionPicture {
    FrameSpec frame;
    QImage image;
    std::vector<QPoint> toggled; ///< came or went since the frame before
    std::vector<QPoint> missing; ///< painted in truth, not here
    std::vector<std::array<LatticePoint, 3>> outlines; ///< of the triangles, on samples
};

/// The picture of a moving scene at a frame of its motion. A pixel is painted if it does not have
/// the background's colour.
MotionPicture motionPicture(const Scene &scene, int frame);

/// One frame of a motion, as large as it fits in whole cells, under the outlines of its triangles.
/// Pixels that came or went since the previous frame have a frame of their own; pixels that only
/// the truth paints have a `?` (objectName "motionView").
class MotionView : public QWidget {
    Q_OBJECT

public:
    explicit MotionView(QWidget *parent = nullptr);

    void setPicture(const MotionPicture &picture);
    const MotionPicture &picture() const { return m_picture; }

    QSize sizeHint() const override { return {280, 220}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    MotionPicture m_picture;
};

} // namespace pixelplumb
