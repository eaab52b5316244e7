// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/linecolumns.h"

#include "core/methods/channelcolumns.h"
#include "core/methods/placecolumns.h"

namespace pixelplumb {

namespace {

using Group = TraceColumnGroup;

const QString px = QStringLiteral("px");
const QString levels = QStringLiteral("levels");

} // namespace

std::vector<TraceColumn> slopeInterceptSetUpColumns()
{
    return {{.id = QStringLiteral("x_0"),
             .title = QStringLiteral("x₀"),
             .unit = px,
             .toolTip = QStringLiteral("The left end point's x."),
             .formula = {}},
            {.id = QStringLiteral("m"),
             .title = QStringLiteral("m"),
             .unit = QStringLiteral("px/column"),
             .toolTip = QStringLiteral("The slope, (y₁ − y₀)/(x₁ − x₀)."),
             .formula = {}},
            {.id = QStringLiteral("b"),
             .title = QStringLiteral("b"),
             .unit = px,
             .toolTip = QStringLiteral("Where the line meets the column 0, y₀ − m·x₀."),
             .formula = {}}};
}

std::vector<TraceColumn> slopeInterceptColumns()
{
    std::vector<TraceColumn> columns
        = {scannedColumn(),
           {.id = QStringLiteral("y"),
            .title = QStringLiteral("y"),
            .unit = px,
            .toolTip = QStringLiteral("Where the line meets the column."),
            .formula = QStringLiteral("y = m·x + b"),
            .group = Group::Decision,
            .comparison = Comparison::WithExact},
           {.id = QStringLiteral("y_r"),
            .title = QStringLiteral("y_r"),
            .unit = px,
            .toolTip = QStringLiteral("The pixel's row: the cast to int drops the fraction, also "
                                      "of a negative number."),
            .formula = QStringLiteral("y_r = (int)(y + ½)"),
            .group = Group::Span,
            .comparison = Comparison::WithExact}};
    appendChannels(columns,
                   {.id = QStringLiteral("%"),
                    .title = QStringLiteral("%"),
                    .unit = levels,
                    .toolTip = QStringLiteral("Level of % at this column."),
                    .formula = {},
                    .group = Group::EdgeColours,
                    .comparison = Comparison::WithExact});
    return columns;
}

std::vector<TraceColumn> ddaSetUpColumns()
{
    std::vector<TraceColumn> columns
        = {{.id = QStringLiteral("u_0"),
            .title = QStringLiteral("u₀"),
            .unit = px,
            .toolTip = QStringLiteral("x₀; y₀ where the line is steep."),
            .formula = {}},
           {.id = QStringLiteral("v_0"),
            .title = QStringLiteral("v₀"),
            .unit = px,
            .toolTip = QStringLiteral("y₀; x₀ where the line is steep."),
            .formula = {}},
           {.id = QStringLiteral("m"),
            .title = QStringLiteral("m"),
            .unit = QStringLiteral("px/step"),
            .toolTip = QStringLiteral("Δy/Δx; Δx/Δy where the line is steep."),
            .formula = {}}};
    appendChannels(columns,
                   {.id = QStringLiteral("delta_%"),
                    .title = QStringLiteral("Δ%"),
                    .unit = QStringLiteral("levels/step"),
                    .toolTip = QStringLiteral("Change of % for each step."),
                    .formula = {},
                    .group = Group::ColourRates});
    return columns;
}

std::vector<TraceColumn> ddaColumns()
{
    std::vector<TraceColumn> columns
        = {pixelX(),
           pixelY(),
           {.id = QStringLiteral("u"),
            .title = QStringLiteral("u"),
            .unit = px,
            .toolTip = QStringLiteral("Along the line: the column; the row where it is steep."),
            .formula = QStringLiteral("u ← u′ + 1"),
            .startFormula = QStringLiteral("u"),
            .group = Group::Span},
           {.id = QStringLiteral("v"),
            .title = QStringLiteral("v"),
            .unit = px,
            .toolTip = QStringLiteral("Across the line: y; x where it is steep."),
            .formula = QStringLiteral("v ← v′ + m"),
            .startFormula = QStringLiteral("v = v₀ + (u − u₀)·m"),
            .group = Group::Decision,
            .comparison = Comparison::WithExact},
           {.id = QStringLiteral("v_r"),
            .title = QStringLiteral("v_r"),
            .unit = px,
            .toolTip = QStringLiteral("The pixel's place across the line, to the nearest; up, or "
                                      "right, from the middle."),
            .formula = QStringLiteral("v_r = ⌊v + ½⌋"),
            .group = Group::Span,
            .comparison = Comparison::WithExact}};
    appendChannels(columns,
                   {.id = QStringLiteral("%"),
                    .title = QStringLiteral("%"),
                    .unit = levels,
                    .toolTip = QStringLiteral("Level of % at this step."),
                    .formula = QStringLiteral("% ← %′ + Δ%"),
                    .startFormula = QStringLiteral("%"),
                    .group = Group::EdgeColours,
                    .comparison = Comparison::WithExact});
    return columns;
}

std::vector<TraceColumn> symmetricSetUpColumns()
{
    return {
        {.id = QStringLiteral("delta_x"),
         .title = QStringLiteral("Δx"),
         .unit = px,
         .toolTip = QStringLiteral("Length along the line, x and y exchanged where it is steep."),
         .formula = {}},
        {.id = QStringLiteral("delta_y"),
         .title = QStringLiteral("Δy"),
         .unit = px,
         .toolTip = QStringLiteral("Length across, without its sign, x and y exchanged where "
                                   "the line is steep."),
         .formula = {}},
        {.id = QStringLiteral("stay"),
         .title = QStringLiteral("2Δy"),
         .unit = {},
         .toolTip = QStringLiteral("Added to p where the line stays."),
         .formula = QStringLiteral("2Δy = 2·Δy"),
         .group = Group::Decision},
        {.id = QStringLiteral("move"),
         .title = QStringLiteral("2Δy − 2Δx"),
         .unit = {},
         .toolTip = QStringLiteral("Added to p where the line goes one across."),
         .formula = QStringLiteral("2Δy − 2Δx = 2·Δy − 2·Δx"),
         .group = Group::Decision}};
}

std::vector<TraceColumn> bresenhamSetUpColumns()
{
    std::vector<TraceColumn> columns = symmetricSetUpColumns();
    columns.push_back({.id = QStringLiteral("p_0"),
                       .title = QStringLiteral("p₀"),
                       .unit = {},
                       .toolTip = QStringLiteral("The first decision parameter."),
                       .formula = QStringLiteral("p₀ = 2Δy − Δx"),
                       .group = Group::Decision});
    return columns;
}

std::vector<TraceColumn> symmetricColumns()
{
    return {{.id = QStringLiteral("k"),
             .title = QStringLiteral("k"),
             .unit = {},
             .toolTip = QStringLiteral("The decision's number; none at the first pixel."),
             .formula = {}},
            {.id = QStringLiteral("p_k"),
             .title = QStringLiteral("p_k"),
             .unit = {},
             .toolTip = QStringLiteral("The decision parameter, (d_lower − d_upper)·Δx: its sign "
                                       "tells which pixel is nearer."),
             .formula = QStringLiteral("p_k ← p_k₊₁′"),
             .startFormula = QStringLiteral("p_k"),
             .group = Group::Decision},
            pixelX(),
            pixelY(),
            {.id = QStringLiteral("increment"),
             .title = QStringLiteral("Δp"),
             .unit = {},
             .toolTip = QStringLiteral("2Δy where the line stays, 2Δy − 2Δx where it goes across."),
             .formula = {},
             .group = Group::Decision},
            {.id = QStringLiteral("p_next"),
             .title = QStringLiteral("p_k₊₁"),
             .unit = {},
             .toolTip = QStringLiteral("The decision parameter for the next pixel."),
             .formula = QStringLiteral("p_k₊₁ = p_k + Δp"),
             .startFormula = QStringLiteral("p_k₊₁"),
             .group = Group::Decision}};
}

std::vector<TraceColumn> bresenhamColumns() { return symmetricColumns(); }

} // namespace pixelplumb
