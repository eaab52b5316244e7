// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/signs.h"
#include "widgets/model/playhead.h"

#include <QtWidgets>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace pixelplumb {

/// A column's place on the screen.
struct ColumnStop {
    std::size_t position = 0; ///< just after it was entered
    double x = 0; ///< its middle, logical pixels; ascending with the position
};

/// Maps positions 0 … end to a stretch of the screen, in logical pixels: spread evenly or, where
/// there are stops, each at its column.
struct ScrubberScale {
    double left = 0;
    double width = 1;
    std::size_t end = 0;
    std::span<const ColumnStop> stops = {};

    double xOf(std::size_t position) const
    {
        if (stops.empty())
            return end == 0 ? left : left + width * (double(position) / double(end));
        const auto next = std::ranges::upper_bound(stops, position, {}, &ColumnStop::position);
        return next == stops.begin() ? left : std::prev(next)->x;
    }
    /// The position nearest to x, also from outside the stretch; for a column, the one just after
    /// it was entered.
    std::size_t positionAt(double x) const
    {
        if (stops.empty()) {
            const double share = std::clamp((x - left) / std::max(1.0, width), 0.0, 1.0);
            return std::size_t(std::llround(share * double(end)));
        }
        if (x >= left + width)
            return end;
        const auto next = std::ranges::lower_bound(stops, x, {}, &ColumnStop::x);
        if (next == stops.end())
            return stops.back().position;
        const double before = next == stops.begin() ? left : std::prev(next)->x;
        if (next->x - x <= x - before)
            return next->position;
        return next == stops.begin() ? 0 : std::prev(next)->position;
    }
};

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
    QString hoverText(const QPointF &position) const;
    QString nameText(const QPointF &position) const; ///< what a lane's name means; none beside it
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
