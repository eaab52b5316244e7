// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/polygoncolumns.h"

#include <array>

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

/// The columns of one crossing; % stands for the subscript in titles, # for it in identifiers.
void appendCrossing(std::vector<TraceColumn> &columns, const QString &subscript, const QString &id)
{
    const std::array<TraceColumn, cellsPerCrossing> pattern = {{
        {.id = QStringLiteral("x_#"),
         .title = QStringLiteral("x%"),
         .unit = QStringLiteral("px"),
         .toolTip = QStringLiteral("Where this edge meets the row; crossings ascend in x."),
         .formula = QStringLiteral("x% = b% + t%·m%"),
         .group = Group::Span,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("edge_#"),
         .title = QStringLiteral("e%"),
         .unit = {},
         .toolTip = QStringLiteral("The edge that crosses here: its place in the contours, "
                                   "from 0."),
         .formula = {},
         .group = Group::Span},
        {.id = QStringLiteral("base_#"),
         .title = QStringLiteral("b%"),
         .unit = QStringLiteral("px"),
         .toolTip = QStringLiteral("The same edge's x on the row before; on its first row, x of "
                                   "its lower end."),
         .formula = {},
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("rise_#"),
         .title = QStringLiteral("t%"),
         .unit = QStringLiteral("rows"),
         .toolTip = QStringLiteral("Rows from there to this row: 1; on the edge's first row, the "
                                   "pre-step from its lower end."),
         .formula = {},
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("slope_#"),
         .title = QStringLiteral("m%"),
         .unit = QStringLiteral("px/row"),
         .toolTip = QStringLiteral("What the edge's x gains from row to row."),
         .formula = {},
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
    }};
    for (TraceColumn column : pattern) {
        column.id.replace(u'#', id);
        column.title.replace(QStringLiteral("%"), subscript);
        column.formula.replace(QStringLiteral("%"), subscript);
        columns.push_back(column);
    }
}

TraceColumn count(const QString &id, const QString &title, const QString &toolTip)
{
    return {.id = id, .title = title, .unit = {}, .toolTip = toolTip, .formula = {}};
}

} // namespace

std::vector<TraceColumn> polygonSetUpColumns(PolygonForm form)
{
    std::vector<TraceColumn> columns = {
        count(QStringLiteral("contours"), QStringLiteral("contours"),
              QStringLiteral("Closed chains of edges: outlines and holes.")),
        count(QStringLiteral("edges"), QStringLiteral("edges"),
              QStringLiteral("Edges of all contours.")),
        count(QStringLiteral("horizontal"), QStringLiteral("horizontal"),
              QStringLiteral("Edges that no row crosses, because they are horizontal; they are not "
                             "in the edge table.")),
    };
    if (form == PolygonForm::Triangles)
        columns.push_back(count(QStringLiteral("triangles"), QStringLiteral("triangles"),
                                QStringLiteral("Triangles that the polygon is broken into.")));
    columns.push_back({.id = QStringLiteral("first_row"),
                       .title = QStringLiteral("y_first"),
                       .unit = QStringLiteral("px"),
                       .toolTip = QStringLiteral("The first row that an edge crosses."),
                       .formula = {}});
    columns.push_back({.id = QStringLiteral("last_row"),
                       .title = QStringLiteral("y_last"),
                       .unit = QStringLiteral("px"),
                       .toolTip = QStringLiteral("The last row that an edge crosses."),
                       .formula = {}});
    return columns;
}

std::vector<TraceColumn> polygonRowColumns(PolygonForm form)
{
    std::vector<TraceColumn> columns = {
        count(QStringLiteral("polygon"), QStringLiteral("poly"),
              QStringLiteral("The primitive's place in drawing order, from 0.")),
        {.id = QStringLiteral("y"),
         .title = QStringLiteral("y"),
         .unit = QStringLiteral("px"),
         .toolTip = QStringLiteral("The row."),
         .formula = {}},
    };
    if (form == PolygonForm::Triangles) {
        columns.push_back(
            count(QStringLiteral("triangle"), QStringLiteral("tri"),
                  QStringLiteral("Which of the polygon's triangles the row belongs to, from 0.")));
        columns.push_back({.id = QStringLiteral("pixels"),
                           .title = QStringLiteral("px"),
                           .unit = {},
                           .toolTip = QStringLiteral("Pixels written in this row of the triangle, "
                                                     "inside the frame: from ⌈x_L⌉ to ⌈x_R⌉ − 1."),
                           .formula = {},
                           .group = Group::Span});
        appendCrossing(columns, QStringLiteral("_L"), QStringLiteral("L"));
        appendCrossing(columns, QStringLiteral("_R"), QStringLiteral("R"));
        return columns;
    }
    columns.push_back({.id = QStringLiteral("active"),
                       .title = QStringLiteral("n"),
                       .unit = {},
                       .toolTip = QStringLiteral("Active edges: those that the row crosses. The "
                                                 "first %1 stand in the table.")
                                      .arg(shownCrossings(form)),
                       .formula = {},
                       .group = Group::Span});
    for (std::size_t i = 0; i < shownCrossings(form); ++i)
        appendCrossing(columns, QChar(u'₀' + char16_t(i)), QString::number(i));
    return columns;
}

std::vector<TraceColumn> polygonSampleColumns(PolygonForm form)
{
    if (form == PolygonForm::Triangles)
        return {};
    return {
        {.id = QStringLiteral("crossings"),
         .title = QStringLiteral("c"),
         .unit = {},
         .toolTip = QStringLiteral("Crossings of the row at or to the left of the sample."),
         .formula = {},
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("parity"),
         .title = QStringLiteral("p"),
         .unit = {},
         .toolTip = QStringLiteral("Their parity; by even-odd the sample is inside where it is 1."),
         .formula = QStringLiteral("p = c mod 2"),
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("winding"),
         .title = QStringLiteral("w"),
         .unit = {},
         .toolTip = QStringLiteral("Crossings by upward edges minus crossings by downward ones; by "
                                   "non-zero the sample is inside where it is not 0."),
         .formula = {},
         .group = Group::Decision,
         .comparison = Comparison::WithExact},
    };
}

} // namespace pixelplumb
