// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"
#include "widgets/stepping/scrubberscale.h"

#include <QAbstractSlider>
#include <QPixmap>

namespace pixelplumb {

/// Where the canvas shows columns, in logical pixels of the scrubber, which is as wide.
struct ColumnPlaces {
    double origin = 0; ///< the middle of column 0
    double width = 0; ///< of a column
    double left = 0, right = 0; ///< the visible range of columns
};

/// The run as a timeline with its marks above it, one lane per kind: vertices, ties, clamps, the
/// first pixel that differs from the truth. The plumb line marks the position; dragging seeks. A
/// run of one primitive in columns is aligned with the canvas's columns at every zoom, so that both
/// plumb lines are one; any other run is spread evenly by its steps.
class Scrubber : public QAbstractSlider {
    Q_OBJECT

public:
    explicit Scrubber(Playhead *playhead, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    ScrubberScale scale() const;
    /// The mark nearest to x within the reach of a click; null when there is none.
    const TraceMark *markNear(double x) const;
    bool isTold(const TraceMark &mark) const; ///< it reveals nothing that lies ahead

public slots:
    void setColumnPlaces(const pixelplumb::ColumnPlaces &places);
    /// Moves just after the next or previous mark's step.
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
    std::vector<std::size_t> m_breakpoints; ///< positions at which a run pauses
    ColumnPlaces m_places;
    std::vector<ColumnStop> m_stops; ///< empty where positions are spread evenly
    std::size_t m_sought = 0; ///< the position the mouse asks for
    QTimer m_seekTimer; ///< one seek per frame, however many mouse moves
    QPixmap m_background; ///< everything but the position; null when it must be repainted
};

/// The sign of a kind of mark.
Sign signOf(MarkKind kind);

} // namespace pixelplumb
