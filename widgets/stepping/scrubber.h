// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"
#include "widgets/stepping/scrubberscale.h"

#include <QAbstractSlider>
#include <QPixmap>

namespace pixelplumb {

/// How the canvas shows columns, in logical pixels of the scrubber, which is as wide.
struct ColumnPlaces {
    double origin = 0; ///< the middle of column 0
    double width = 0; ///< of a column
    double left = 0, right = 0; ///< where columns are seen
};

/// The run on one line, with its marks in a lane a kind above it: where vertices are, where ties
/// and clamps happen, the first pixel that differs from the truth. The plumb line marks the
/// position; dragging seeks. A run of one primitive in columns stands below the canvas's columns,
/// at every zoom, so that the plumb line is one line; every other is spread evenly by its steps.
class Scrubber : public QAbstractSlider {
    Q_OBJECT

public:
    explicit Scrubber(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    ScrubberScale scale() const;
    /// The mark nearest to x within the reach of a click; null when there is none.
    const TraceMark *markNear(double x) const;
    bool isTold(const TraceMark &mark) const; ///< no secret of what lies ahead

public slots:
    void setColumnPlaces(const pixelplumb::ColumnPlaces &places);
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
    void findStops();
    void forgetBackground();
    void seekSoon(std::size_t position);
    QString hoverText(double x) const;
    void paintBackground();
    void paintPosition(QPainter &painter) const;
    void paintLane(QPainter &painter, int lane, MarkKind kind, const QString &name) const;
    void paintMarks(QPainter &painter, double top, MarkKind kind) const;
    void paintTrack(QPainter &painter) const;
    void paintName(QPainter &painter, double top, double height, const QString &name) const;
    QRectF lanes() const;

    Playhead *m_playhead;
    std::vector<std::size_t> m_breakpoints; ///< the positions at which a run pauses
    ColumnPlaces m_places;
    std::vector<ColumnStop> m_stops; ///< empty where positions are spread evenly
    std::size_t m_sought = 0; ///< where the mouse wants to go
    QTimer m_seekTimer; ///< one seek a frame, however many mouse moves
    QPixmap m_background; ///< everything but the position; null when it has to be painted anew
};

/// The sign that stands for a kind of mark.
Sign signOf(MarkKind kind);

} // namespace pixelplumb
