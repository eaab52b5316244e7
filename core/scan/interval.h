// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/scan/boundaryrule.h"

namespace pixelplumb {

/// Which of its two bounds belong to an interval.
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

/// What a column scan makes of a fill rule: the columns from the triangle's first vertex to its
/// last, and the rows of a column from y_B to y_T.
struct ScanIntervals {
    Interval columns = Interval::Closed;
    Interval rows = Interval::Closed;
};

/// Of the columns from left to right; closed, open or half-open-column.
constexpr ScanIntervals columnIntervals(FillRule rule)
{
    if (rule == FillRule::Closed)
        return {Interval::Closed, Interval::Closed};
    if (rule == FillRule::Open)
        return {Interval::Open, Interval::Open};
    return {Interval::ClosedOpen, Interval::ClosedOpen};
}

/// Of the rows from the highest y to the lowest, which then are columns; closed, open or top-left.
/// Down as seen is onward where y points up and back where it points down.
constexpr ScanIntervals rowIntervals(const BoundaryRule &rule)
{
    ScanIntervals intervals = columnIntervals(rule.rule);
    if (rule.rule == FillRule::TopLeft && rule.down() > 0)
        intervals.columns = Interval::OpenClosed;
    return intervals;
}

} // namespace pixelplumb
