// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curvecolumns.h"

#include "core/methods/placecolumns.h"

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

TraceColumn column(const char *id, const QString &title, const char *unit, const QString &toolTip,
                   const QString &formula = {}, Group group = Group::Position)
{
    return {.id = QString::fromUtf8(id),
            .title = title,
            .unit = QString::fromUtf8(unit),
            .toolTip = toolTip,
            .formula = formula,
            .group = group};
}

TraceColumn numberColumn(const QString &toolTip)
{
    return column("i", QStringLiteral("i"), "", toolTip);
}

} // namespace

std::vector<TraceColumn> pointSetUpColumns()
{
    return {column("width", QStringLiteral("width"), "px",
                   QStringLiteral("Pixels in a row of the frame.")),
            column("x_0", QStringLiteral("x₀"), "px", QStringLiteral("The frame's first column.")),
            column("y_0", QStringLiteral("y₀"), "px", QStringLiteral("The frame's first row."))};
}

std::vector<TraceColumn> pointColumns()
{
    return {numberColumn(QStringLiteral("The point's number, from 0.")), pixelX(), pixelY(),
            column("addr", QStringLiteral("addr"), "px",
                   QStringLiteral("The pixel's address in the frame, counted in pixels from its "
                                  "first one; none outside the frame."),
                   QStringLiteral("addr = (y − y₀)·width + (x − x₀)"), Group::Decision)};
}

std::vector<TraceColumn> roundSetUpColumns()
{
    return {column("x_c", QStringLiteral("x_c"), "px", QStringLiteral("The centre's x.")),
            column("y_c", QStringLiteral("y_c"), "px", QStringLiteral("The centre's y.")),
            column("r_x", QStringLiteral("r_x"), "px",
                   QStringLiteral("The radius along x: r of a circle, a of an ellipse.")),
            column("r_y", QStringLiteral("r_y"), "px",
                   QStringLiteral("The radius along y: r of a circle, b of an ellipse."))};
}

std::vector<TraceColumn> circleFillColumns()
{
    return {column("y", QStringLiteral("y"), "px", QStringLiteral("The row.")),
            column("x_L", QStringLiteral("x_L"), "px",
                   QStringLiteral("Where the row meets the curve on the left, up to the next "
                                  "1/256 px: the first lattice point inside.")),
            column("x_R", QStringLiteral("x_R"), "px",
                   QStringLiteral("Where the row meets the curve on the right, down to the next "
                                  "1/256 px: the last lattice point inside.")),
            column("first", QStringLiteral("x_first"), "px",
                   QStringLiteral("The first covered column."), QStringLiteral("x_first = ⌈x_L⌉"),
                   Group::Span),
            column("last", QStringLiteral("x_last"), "px",
                   QStringLiteral("The last covered column."), QStringLiteral("x_last = ⌊x_R⌋"),
                   Group::Span)};
}

std::vector<TraceColumn> circleExplicitColumns()
{
    return {scannedColumn(),
            column("d", QStringLiteral("d"), "px", QStringLiteral("The column from the centre."),
                   QStringLiteral("d = x − x_c")),
            column("h", QStringLiteral("h"), "px",
                   QStringLiteral("√(r² − d²); of an ellipse, (b/a)·√(a² − d²). Exact arithmetic "
                                  "has no root: it takes the root down to 1/256 px, which decides "
                                  "every rounding as the root itself would."),
                   QStringLiteral("h = r_y/r_x·√(r_x² − d²)"), Group::Decision),
            column("y_above", QStringLiteral("y_T"), "px",
                   QStringLiteral("The pixel above, to the nearest row."),
                   QStringLiteral("y_T = ⌊y_c + h + ½⌋"), Group::Span),
            column("y_below", QStringLiteral("y_B"), "px",
                   QStringLiteral("The pixel below, to the nearest row."),
                   QStringLiteral("y_B = ⌈y_c − h − ½⌉"), Group::Span)};
}

std::vector<TraceColumn> circleParametricSetUpColumns()
{
    std::vector<TraceColumn> columns = roundSetUpColumns();
    columns.push_back(column("delta_theta", QStringLiteral("Δθ"), "rad",
                             QStringLiteral("The step of the angle: one over the radius (the "
                                            "larger one), one pixel of arc.")));
    return columns;
}

std::vector<TraceColumn> circleParametricColumns()
{
    return {numberColumn(QStringLiteral("The step's number, from 0 at θ = 0.")),
            column("theta", QStringLiteral("θ"), "rad", QStringLiteral("The angle."),
                   QStringLiteral("θ = i·Δθ"), Group::Decision),
            column("u", QStringLiteral("u"), "px", QStringLiteral("The point's x."),
                   QStringLiteral("u = x_c + r_x·cos θ"), Group::Decision),
            column("v", QStringLiteral("v"), "px", QStringLiteral("The point's y."),
                   QStringLiteral("v = y_c + r_y·sin θ"), Group::Decision),
            column("x", QStringLiteral("x"), "px", QStringLiteral("The nearest pixel's x."),
                   QStringLiteral("x = ⌊u + ½⌋"), Group::Span),
            column("y", QStringLiteral("y"), "px", QStringLiteral("The nearest pixel's y."),
                   QStringLiteral("y = ⌊v + ½⌋"), Group::Span)};
}

std::vector<TraceColumn> circleMidpointColumns()
{
    TraceColumn decision
        = column("p_k", QStringLiteral("p_k"), "",
                 QStringLiteral("F at the midpoint between two rows: positive outside, so that the "
                                "lower row is nearer."),
                 QStringLiteral("p_k ← p_k₊₁′"), Group::Decision);
    decision.startFormula = QStringLiteral("p_k");
    TraceColumn next
        = column("p_next", QStringLiteral("p_k₊₁"), "", QStringLiteral("F at the next midpoint."),
                 QStringLiteral("p_k₊₁ = p_k + Δp"), Group::Decision);
    next.startFormula = QStringLiteral("p_k₊₁");
    return {column("arc", QStringLiteral("arc"), "",
                   QStringLiteral("1: x_k along x, mirrored into all octants of a circle; 2: x_k "
                                  "along y, of an ellipse.")),
            decision,
            column("x_k", QStringLiteral("x_k"), "px",
                   QStringLiteral("From the centre along the arc.")),
            column("y_k", QStringLiteral("y_k"), "px",
                   QStringLiteral("From the centre across the arc.")),
            column("increment", QStringLiteral("Δp"), "",
                   QStringLiteral("2x_k + 1 where the row stays, less 2y_k where it goes one down; "
                                  "of an ellipse times b² and a².")),
            next};
}

std::vector<TraceColumn> bezierSetUpColumns()
{
    return {column("degree", QStringLiteral("n"), "",
                   QStringLiteral("The degree: 2 quadratic, 3 cubic.")),
            column("tolerance", QStringLiteral("ε"), "px",
                   QStringLiteral("A piece is flat that lies within this distance of its chord."))};
}

std::vector<TraceColumn> bezierColumns()
{
    std::vector<TraceColumn> columns = {
        numberColumn(QStringLiteral("The piece's number, from 0 for the whole curve.")),
        column("depth", QStringLiteral("depth"), "",
               QStringLiteral("How often the curve was halved to get this piece.")),
        column("flatness", QStringLiteral("δ"), "px",
               QStringLiteral("No point is farther from the chord: n·(n − 1)/8 times the largest "
                              "second difference of the control points."),
               {}, Group::Decision),
        column("flat", QStringLiteral("flat"), "",
               QStringLiteral("1: drawn as a line between its ends; 0: halved."), {},
               Group::Decision)};
    for (int control = 0; control < 4; ++control) {
        for (const QChar axis : {u'x', u'y'}) {
            const QString name = QString(axis) + QChar(0x2080 + control);
            columns.push_back({.id = QStringLiteral("%1_%2").arg(axis).arg(control),
                               .title = name,
                               .unit = QStringLiteral("px"),
                               .toolTip = QStringLiteral("Control point P%1.").arg(control),
                               .formula = {},
                               .group = Group::Span});
        }
    }
    return columns;
}

} // namespace pixelplumb
