// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPointF>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace pixelplumb {

/// What a layer's mark stands for; its colour follows from it (colourOf).
enum class LayerInk {
    Mark, ///< edges, numbers and whatever has a name beside it
    First, ///< the first of two or three things that belong together: α, β's axis, R
    Second,
    Third,
    Inside, ///< where an edge function is positive, a parity odd
    Negative, ///< a number below 0, besides its minus sign
    Hand, ///< of the current step
};

/// What layers draw over the frame, as numbers: places are sample coordinates, px, so that pixel
/// (x, y) is the point (x, y). One painter paints it at any scale (LayerPainter).
struct LayerDrawing {
    /// A band is wide enough to be visible beside a line along it.
    enum class Stroke { Solid, Dashed, Dotted, Arrow, Band };
    struct Line {
        QPointF from, to; ///< an arrow points to the second
        LayerInk ink = LayerInk::Mark;
        Stroke stroke = Stroke::Solid;

        friend bool operator==(const Line &, const Line &) = default;
    };
    /// A convex polygon, tinted.
    struct Area {
        std::vector<QPointF> corners;
        LayerInk ink = LayerInk::Inside;

        friend bool operator==(const Area &, const Area &) = default;
    };
    struct Circle {
        QPointF centre;
        double radius = 0;
        LayerInk ink = LayerInk::Mark;

        friend bool operator==(const Circle &, const Circle &) = default;
    };
    struct Point {
        QPointF place;
        LayerInk ink = LayerInk::Mark;

        friend bool operator==(const Point &, const Point &) = default;
    };
    /// A distance between two places: a line with a tick at each end, drawn beside the way from the
    /// first to the second, on its right on the screen, and its text next to the line.
    struct Measure {
        QPointF from, to;
        QString text;
        LayerInk ink = LayerInk::Mark;
        QPointF way = to - from; ///< its direction, which a distance of 0 has too; never null

        friend bool operator==(const Measure &, const Measure &) = default;
    };
    /// The places p with (p − onBorder)·inward ≥ 0.
    struct HalfPlane {
        QPointF onBorder, inward;

        friend bool operator==(const HalfPlane &, const HalfPlane &) = default;
    };
    /// A name beside a place, where there is room.
    struct Label {
        QString text;
        QPointF place;
        LayerInk ink = LayerInk::Mark;
        /// The half-plane that must hold the whole name, else it is left out; none: anywhere.
        std::optional<HalfPlane> side = {};
        /// If the place has no room, the name goes beside the first of these that has.
        std::vector<QPointF> otherPlaces = {};
        /// What other labels name: if there is room, the name is no nearer to these than to its own
        /// place.
        std::vector<QLineF> rivals = {};

        friend bool operator==(const Label &, const Label &) = default;
    };
    /// A number in a pixel's cell, below those already there.
    struct CellText {
        std::int64_t x = 0, y = 0; ///< the pixel
        QString text;
        LayerInk ink = LayerInk::Mark;

        friend bool operator==(const CellText &, const CellText &) = default;
    };

    std::vector<Area> areas; ///< below all else
    std::vector<Line> lines;
    std::vector<Circle> circles;
    std::vector<Point> points;
    std::vector<Point> samples; ///< in each cell; numbers keep clear of them
    std::vector<Measure> measures;
    std::vector<Label> labels;
    std::vector<CellText> cells;
    QStringList cellNames; ///< what the texts in a cell are, from the top
    /// Notes to show with the picture: that numbers are the exact ones, because the method has
    /// none; that cells are too small for them.
    QStringList notes;

    /// Whether there are texts beside places.
    bool hasNames() const { return !labels.empty() || !measures.empty(); }

    bool isEmpty() const
    {
        return areas.empty() && lines.empty() && circles.empty() && points.empty()
            && samples.empty() && !hasNames() && cells.empty();
    }

    friend bool operator==(const LayerDrawing &, const LayerDrawing &) = default;
};

} // namespace pixelplumb
