// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/scan/boundaryrule.h"

namespace pixelplumb {

/// Which of an interval's two bounds belong to it.
enum class Interval { Closed, ClosedOpen, OpenClosed, Open };

constexpr bool ownsFirst(Interval interval)
{
    return interval == Interval::Closed || interval == Interval::ClosedOpen;
}
constexpr bool ownsLast(Interval interval)
{
    return interval == Interval::Closed || interval == Interval::OpenClosed;
}

/// The first sample of an interval that begins at a coordinate, lattice units.
constexpr std::int64_t firstSampleFrom(Lattice coordinate, Interval interval)
{
    return ownsFirst(interval) ? ceilPixel(coordinate) : floorPixel(coordinate) + 1;
}
/// One past the last sample of an interval that ends at a coordinate.
constexpr std::int64_t endSampleAt(Lattice coordinate, Interval interval)
{
    return ownsLast(interval) ? floorPixel(coordinate) + 1 : ceilPixel(coordinate);
}

/// How a column scan applies a fill rule: to the columns from the triangle's first vertex to its
/// last, and to the rows of a column from y_B to y_T.
struct ScanIntervals {
    Interval columns = Interval::Closed;
    Interval rows = Interval::Closed;
};

/// For columns from left to right; closed, open or half-open-column. For top-left only the columns
/// hold: its rows depend on the edges.
constexpr ScanIntervals columnIntervals(FillRule rule)
{
    if (rule == FillRule::Closed)
        return {Interval::Closed, Interval::Closed};
    if (rule == FillRule::Open)
        return {Interval::Open, Interval::Open};
    return {Interval::ClosedOpen, Interval::ClosedOpen};
}

/// The rows of a column between two edges, whose rises from left to right are given. Only top-left
/// looks at the rises: displaced to the right, a sample on a falling edge lies above it, on a
/// rising one below; on a level edge the smaller displacement, down on the screen, decides. The
/// columns are those of columnIntervals().
constexpr Interval rowsBetween(const BoundaryRule &rule, Lattice lowerRise, Lattice upperRise)
{
    if (rule.rule != FillRule::TopLeft)
        return columnIntervals(rule.rule).rows;
    const bool ownsLower = lowerRise < 0 || (lowerRise == 0 && rule.down() > 0);
    const bool ownsUpper = upperRise > 0 || (upperRise == 0 && rule.down() < 0);
    if (ownsLower)
        return ownsUpper ? Interval::Closed : Interval::ClosedOpen;
    return ownsUpper ? Interval::OpenClosed : Interval::Open;
}

/// For rows from the highest y to the lowest, scanned as columns; closed, open or top-left. Down on
/// the screen is forward where y points up and backward where it points down.
constexpr ScanIntervals rowIntervals(const BoundaryRule &rule)
{
    ScanIntervals intervals = columnIntervals(rule.rule);
    if (rule.rule == FillRule::TopLeft && rule.down() > 0)
        intervals.columns = Interval::OpenClosed;
    return intervals;
}

} // namespace pixelplumb
