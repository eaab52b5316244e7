// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>

namespace pixelplumb {

/// One frame of a motion, as large as it fits in whole cells, with the pixels that came or went
/// since the frame before in a frame of their own (objectName "motionView").
class MotionView : public QWidget {
    Q_OBJECT

public:
    explicit MotionView(QWidget *parent = nullptr);

    /// Both as pictures show them, top line first; of the first frame, nothing before.
    void setPictures(const QImage &now, const QImage &before);
    int toggledPixels() const; ///< as they are shown

    QSize sizeHint() const override { return {280, 220}; }
    QSize minimumSizeHint() const override { return {120, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    bool isToggled(int x, int line) const;

    QImage m_now, m_before;
};

} // namespace pixelplumb
