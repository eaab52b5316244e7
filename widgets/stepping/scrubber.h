// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"
#include "widgets/stepping/scrubberscale.h"

#include <QAbstractSlider>
#include <QPixmap>

namespace pixelplumb {

/// The whole run on one line, with its marks in a lane a kind above it: where vertices are, where
/// ties and clamps happen, the first pixel that differs from the truth. The plumb line marks the
/// position; dragging seeks.
class Scrubber : public QAbstractSlider {
    Q_OBJECT

public:
    explicit Scrubber(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    ScrubberScale scale() const;
    /// The mark nearest to x within the reach of a click; null when there is none.
    const TraceMark *markNear(double x) const;

public slots:
    /// Just after the next or previous mark's step.
    void goToMark(pixelplumb::StepDirection direction);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void takeTrace();
    void followPlayhead();
    void findBreakpoints();
    void forgetBackground();
    void seekSoon(std::size_t position);
    QString hoverText(double x) const;
    void paintBackground();
    void paintLane(QPainter &painter, int lane, MarkKind kind, const QString &name) const;
    void paintTrack(QPainter &painter) const;

    Playhead *m_playhead;
    std::vector<std::size_t> m_breakpoints; ///< the positions at which a run pauses
    std::size_t m_sought = 0; ///< where the mouse wants to go
    QTimer m_seekTimer; ///< one seek a frame, however many mouse moves
    QPixmap m_background; ///< everything but the position; null when it has to be painted anew
};

/// The sign that stands for a kind of mark.
Sign signOf(MarkKind kind);

} // namespace pixelplumb
