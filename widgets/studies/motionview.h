// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/studies/motionpicture.h"

#include <QWidget>

class QPainter;

namespace pixelplumb {

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
    void drawMissing(QPainter &painter, double cell) const;

    MotionPicture m_picture;
};

} // namespace pixelplumb
