// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/trianglebatch.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// Which samples the spans of a triangle consist of: an interval of rows in each column, as in the
/// assignment, or an interval of columns in each row. Either way they are the same samples.
enum class SpanAxis { RowsOfColumn, ColumnsOfRow };

/// One edge as a line over the columns (or rows): ⌈constant + slope · n⌉ bounds the span of column
/// n, as its first row or as the row after its last.
struct EdgeLine {
    double constant = 0;
    double slope = 0;
};

/// The edges that bound the spans of a triangle: a span begins at the larger of the two lower
/// bounds and ends before the smaller of the upper ones.
///
/// The assignment's ⌈y_B⌉ … ⌊y_T⌋ without a rounding error (numerics.md, 3.2): y is a multiple of
/// 1/D, D = 256·ΔX. Where the boundary belongs to the span, ⌈y − 1/(2D)⌉ = ⌈y⌉ begins it and ⌈y +
/// 1/(2D)⌉ = ⌊y⌋ + 1 ends it; where it does not, the signs change places. All four allow an error
/// below 1/(2D). Here the constant is one rounded quotient of integers, (Ya·ΔX − Xa·ΔY ± 1/2)/D
/// with a numerator below 2^49 that double holds exactly, so |constant| <= 2^40/ΔX; |slope · n| <=
/// 2^39/ΔX; and the error of the sum is at most 2^-53·(2·2^40 + 3·2^39)/ΔX < 2^-11/ΔX, a quarter of
/// 1/(2D) = 2^-9/ΔX.
struct EdgeLines {
    static constexpr double unbounded = double(std::int64_t(1) << 40);

    std::array<EdgeLine, 2> lower = {{{-unbounded, 0}, {-unbounded, 0}}};
    std::array<EdgeLine, 2> upper = {{{unbounded, 0}, {unbounded, 0}}};
};

/// Whether the samples on an edge belong to the triangle: all under the closed rule; under the
/// half-open one those that the displacement (+ε², +ε) moves inside. The edge function grows by
/// `perColumn` and `perRow` towards the inside.
template <FillRule Rule>
constexpr bool ownsBoundary(double perColumn, double perRow)
{
    return Rule == FillRule::Closed || perRow > 0 || (perRow == 0 && perColumn > 0);
}

template <FillRule Rule, SpanAxis Axis>
EdgeLines edgeLinesOf(const TriangleBatch &batch, std::size_t i)
{
    EdgeLines lines;
    std::size_t lowerCount = 0;
    std::size_t upperCount = 0;
    const double sign = batch.signedArea[i] < 0 ? -1 : 1;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = a == 2 ? 0 : a + 1;
        const double dx = double(batch.x[b][i]) - batch.x[a][i];
        const double dy = double(batch.y[b][i]) - batch.y[a][i];
        const double perColumn = -sign * dy;
        const double perRow = sign * dx;
        constexpr bool overColumns = Axis == SpanAxis::RowsOfColumn;
        const double run = overColumns ? dx : dy;
        if (run == 0)
            continue; // parallel to the spans: it bounds the range of columns, not a span
        const double rise = overColumns ? dy : dx;
        const double alongA = overColumns ? batch.x[a][i] : batch.y[a][i];
        const double acrossA = overColumns ? batch.y[a][i] : batch.x[a][i];
        const bool begins = (overColumns ? perRow : perColumn) > 0;
        const bool owned = ownsBoundary<Rule>(perColumn, perRow);
        const double bias = begins == owned ? -0.5 : 0.5;
        const double direction = run < 0 ? -1 : 1;
        const double numerator = direction * (acrossA * run - alongA * rise) + bias;
        const EdgeLine line = {numerator / (direction * run * double(unitsPerPixel)), rise / run};
        if (begins)
            lines.lower[lowerCount++] = line;
        else
            lines.upper[upperCount++] = line;
    }
    return lines;
}

} // namespace pixelplumb
