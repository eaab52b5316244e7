// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

#include <vector>

namespace pixelplumb {

/// A frame's picture, and the pixels that came or went since the frame before: places in the
/// picture, from its top left corner.
struct MotionPicture {
    QImage image;
    std::vector<QPoint> toggled;
};

/// One frame of a motion, as large as it fits in whole cells, with the pixels that came or went
/// since the frame before in a frame of their own (objectName "motionView").
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
