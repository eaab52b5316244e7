// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/columnscancolumns.h"

#include "core/methods/channelcolumns.h"
#include "core/methods/placecolumns.h"

#include <array>

namespace pixelplumb {

std::vector<TraceColumn> columnScanColumns()
{
    using Group = TraceColumnGroup;
    const auto levels = QStringLiteral("levels");
    const auto px = QStringLiteral("px");
    std::vector<TraceColumn> columns = {
        triangleColumn(),
        scannedColumn(QStringLiteral("x ← x + 1")),
        halfColumn(),
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
        columnPixelsColumn(),
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
