// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscancolumns.h"

#include <array>

namespace pixelplumb {

namespace {

constexpr std::array letters = {u'R', u'G', u'B'};

/// One column for each channel; % stands for its letter.
void appendChannels(std::vector<TraceColumn> &columns, const TraceColumn &pattern)
{
    for (const char16_t letter : letters) {
        TraceColumn column = pattern;
        for (QString *text : {&column.id, &column.title, &column.toolTip, &column.formula})
            text->replace(u'%', QChar(letter));
        columns.push_back(column);
    }
}

} // namespace

std::vector<TraceColumn> columnScanColumns()
{
    using Group = TraceColumnGroup;
    const auto levels = QStringLiteral("levels");
    const auto px = QStringLiteral("px");
    std::vector<TraceColumn> columns = {
        {.id = QStringLiteral("triangle"),
         .title = QStringLiteral("tri"),
         .unit = {},
         .toolTip = QStringLiteral("The triangle's place in drawing order, from 0."),
         .formula = {}},
        {.id = QStringLiteral("x"),
         .title = QStringLiteral("x"),
         .unit = px,
         .toolTip = QStringLiteral("The column."),
         .formula = QStringLiteral("x ← x + 1")},
        {.id = QStringLiteral("half"),
         .title = QStringLiteral("half"),
         .unit = {},
         .toolTip = QStringLiteral("1: between L₀₁ and L₀₂; 2: between L₁₂ and L₀₂."),
         .formula = {}},
        {.id = QStringLiteral("y_B"),
         .title = QStringLiteral("y_B"),
         .unit = px,
         .toolTip = QStringLiteral("Where the lower edge meets the column."),
         .formula = QStringLiteral("y_B ← y_B + slope"),
         .group = Group::Span,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("y_T"),
         .title = QStringLiteral("y_T"),
         .unit = px,
         .toolTip = QStringLiteral("Where the upper edge meets the column."),
         .formula = QStringLiteral("y_T ← y_T + slope"),
         .group = Group::Span,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("first_row"),
         .title = QStringLiteral("⌈y_B⌉"),
         .unit = px,
         .toolTip = QStringLiteral("The first covered row."),
         .formula = QStringLiteral("⌈y_B⌉"),
         .group = Group::Span,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("last_row"),
         .title = QStringLiteral("⌊y_T⌋"),
         .unit = px,
         .toolTip = QStringLiteral(
             "The last covered row: ⌊y_T⌋ under closed, ⌈y_T⌉ − 1 under half-open-column."),
         .formula = QStringLiteral("⌊y_T⌋"),
         .group = Group::Span,
         .comparison = Comparison::WithExact},
        {.id = QStringLiteral("pixels"),
         .title = QStringLiteral("px"),
         .unit = {},
         .toolTip = QStringLiteral("Pixels written in this column, inside the frame."),
         .formula = {},
         .group = Group::Span},
    };
    appendChannels(columns,
                   {.id = QStringLiteral("%_B"),
                    .title = QStringLiteral("%_B"),
                    .unit = levels,
                    .toolTip = QStringLiteral("Level of % where the lower edge meets the column."),
                    .formula = QStringLiteral("%_B ← %_B + (%₁ − %₀)/(x₁ − x₀)"),
                    .group = Group::EdgeColours,
                    .comparison = Comparison::WithExact});
    appendChannels(columns,
                   {.id = QStringLiteral("%_T"),
                    .title = QStringLiteral("%_T"),
                    .unit = levels,
                    .toolTip = QStringLiteral("Level of % where the upper edge meets the column."),
                    .formula = QStringLiteral("%_T ← %_T + (%₂ − %₀)/(x₂ − x₀)"),
                    .group = Group::EdgeColours,
                    .comparison = Comparison::WithExact});
    appendChannels(columns,
                   {.id = QStringLiteral("delta_%"),
                    .title = QStringLiteral("Δ%"),
                    .unit = QStringLiteral("levels/row"),
                    .toolTip = QStringLiteral("Change of % for each upward move."),
                    .formula = QStringLiteral("Δ% = (%_T − %_B)/(y_T − y_B)"),
                    .group = Group::ColourRates,
                    .comparison = Comparison::WithExact});
    appendChannels(columns,
                   {.id = QStringLiteral("first_%"),
                    .title = QStringLiteral("first %"),
                    .unit = levels,
                    .toolTip = QStringLiteral("Level of % at the column's first drawn pixel."),
                    .formula = QStringLiteral("% = %_B + (⌈y_B⌉ − y_B)·Δ%"),
                    .group = Group::FirstColour});
    return columns;
}

std::vector<TraceColumn> columnScanSetUpColumns()
{
    const std::array edges = {QStringLiteral("₀₁"), QStringLiteral("₁₂"), QStringLiteral("₀₂")};
    const std::array files = {QStringLiteral("01"), QStringLiteral("12"), QStringLiteral("02")};
    std::vector<TraceColumn> columns;
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        columns.push_back({.id = QStringLiteral("m_") + files[edge],
                           .title = QStringLiteral("m") + edges[edge],
                           .unit = QStringLiteral("px/column"),
                           .toolTip = QStringLiteral("Slope of the edge L%1.").arg(edges[edge]),
                           .formula = {}});
    }
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        appendChannels(columns,
                       {.id = QStringLiteral("rate_%_") + files[edge],
                        .title = QStringLiteral("rate of % on L") + edges[edge],
                        .unit = QStringLiteral("levels/column"),
                        .toolTip = QStringLiteral("Change of % along the edge, for each column."),
                        .formula = {}});
    }
    return columns;
}

} // namespace pixelplumb
