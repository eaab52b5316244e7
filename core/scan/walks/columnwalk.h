// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/primitiverejection.h"
#include "core/scan/columnstate.h"
#include "core/scan/interval.h"
#include "core/scan/workstage.h"

#include <algorithm>
#include <type_traits>

/// The walk over the columns of a triangle, from left to right, each between two of its edges: L₀₁
/// and L₀₂ up to x₁, then L₁₂ and L₀₂. The column scan, interpolation and shading walk alike; what
/// they carry along the edges and what they do in a column is their own.
namespace pixelplumb {

/// The positions of P0, P1, P2.
using SortedCorners = std::array<LatticePoint, 3>;
/// Which of them an edge connects.
using SortedEnds = std::array<std::size_t, 2>;

/// The columns [first, end) of a triangle in a frame.
struct WalkedColumns {
    std::int64_t first = 0;
    std::int64_t end = 0;

    bool isEmpty() const { return first >= end; }
};

inline ColumnRange columnRangeOf(const Triangle &triangle, Interval columns)
{
    ColumnRange range;
    range.order = sortedByColumn(triangle);
    const auto position = [&](std::size_t corner) {
        return triangle.vertices[std::size_t(range.order[corner])].position;
    };
    const Int128 area = doubledArea(position(0), position(1), position(2));
    range.zeroArea = area == 0;
    range.longEdge = area >= 0 ? LongEdge::Above : LongEdge::Below;
    range.firstColumn = firstSampleFrom(position(0).x, columns);
    range.middleColumn = ceilPixel(position(1).x);
    range.endColumn = endSampleAt(position(2).x, columns);
    return range;
}

/// None where all vertices lie above or below the frame; usually the first one decides that.
template <class View>
WalkedColumns columnsInFrame(const ColumnRange &range, const SortedCorners &corners,
                             const View &frame)
{
    const WalkedColumns columns{std::max<std::int64_t>(range.firstColumn, frame.firstColumn),
                                std::min(range.endColumn, frame.endColumn())};
    const auto all = [&](const auto &isThere) {
        return isThere(corners[0].y) && isThere(corners[1].y) && isThere(corners[2].y);
    };
    if (columns.isEmpty()
        || all([&](Lattice y) { return y > (frame.endRow() - 1) * unitsPerPixel; })
        || all([&](Lattice y) { return y < frame.firstRow * unitsPerPixel; }))
        return {};
    return columns;
}

/// Walks the columns of one half. The scan says what walks along an edge, walkerOn(ends, column),
/// which rows belong to a column beside it, rowsOf(ends of the short edge), what is done in one,
/// scanColumn(half, rows, x, short walker, long walker), and whether an empty half begins no edge,
/// skipsEmptyHalf: that branch can cost full halves a third of a percent. Force-inlined, as these
/// are: an edge that goes through memory is read in words of another size than it was stored in,
/// and waits until every earlier pixel is stored.
template <class Scan, class Observer, class Walker>
[[gnu::always_inline]] inline void walkHalf(Scan &scan, ColumnHalf half,
                                            const WalkedColumns &columns, const Observer &observer,
                                            Walker &longEdge)
{
    if constexpr (std::remove_cvref_t<Scan>::skipsEmptyHalf) {
        if (columns.isEmpty())
            return;
    }
    const SortedEnds ends = half == ColumnHalf::First ? SortedEnds{0, 1} : SortedEnds{1, 2};
    Walker shortEdge = scan.walkerOn(ends, columns.first);
    const Interval rows = scan.rowsOf(ends);
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
        [[maybe_unused]] const WorkScope span(observer, WorkStage::Span);
        scan.scanColumn(half, rows, x, shortEdge, longEdge);
        shortEdge.stepToNextColumn();
        longEdge.stepToNextColumn();
    }
}

/// Walks a triangle that has area. L₀₂ is not restarted at x₁: it goes on adding its slope.
template <class Scan, class Observer>
[[gnu::always_inline]] inline void walkHalves(Scan &&scan, const ColumnRange &range,
                                              const WalkedColumns &columns,
                                              const Observer &observer)
{
    const std::int64_t middle = std::clamp(range.middleColumn, columns.first, columns.end);
    auto longEdge = scan.walkerOn(SortedEnds{0, 2}, columns.first);
    walkHalf(scan, ColumnHalf::First, {columns.first, middle}, observer, longEdge);
    walkHalf(scan, ColumnHalf::Second, {middle, columns.end}, observer, longEdge);
}

/// Walks a triangle without area under the closed rule: both bounds of every column are L₀₂. A
/// vertical segment is the one column from P0 to P2, since its edges stay at their first vertices.
/// Where x₀ = x₁ there is no first half.
template <class Observer, class WalkerOn, class ScanColumn>
void walkSegment(const SortedCorners &corners, const WalkedColumns &columns,
                 const Observer &observer, const WalkerOn &walkerOn, const ScanColumn &scanColumn)
{
    const bool isVertical = corners[0].x == corners[2].x;
    const ColumnHalf half = corners[0].x == corners[1].x ? ColumnHalf::Second : ColumnHalf::First;
    auto lower = walkerOn(SortedEnds{0, 2}, columns.first);
    auto upper = walkerOn(SortedEnds{std::size_t(isVertical ? 2 : 0), 2}, columns.first);
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
        [[maybe_unused]] const WorkScope span(observer, WorkStage::Span);
        scanColumn(half, x, lower, upper);
        lower.stepToNextColumn();
        upper.stepToNextColumn();
    }
}

/// Walks a triangle whose set-up is announced, or announces why none of it is drawn. The scan also
/// says how it walks a segment, scanSegment(scan, columns).
template <class Scan, class View, class Observer>
[[gnu::always_inline]] inline void walkTriangle(Scan &scan, const ColumnRange &range,
                                                Interval inColumns, const SortedCorners &corners,
                                                const View &frame, Observer &observer)
{
    if (range.zeroArea && inColumns != Interval::Closed) {
        observer.primitiveRejected(PrimitiveRejection::ZeroArea);
        return;
    }
    const WalkedColumns columns = columnsInFrame(range, corners, frame);
    if (columns.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    if (range.zeroArea)
        Scan::scanSegment(scan, columns);
    else
        walkHalves(scan, range, columns, observer);
}

/// The assignment has y_B ≤ y_T in each column: where rounding makes the edges cross, as it does
/// near the last vertex, the column still reaches from one to the other. Under the other rules such
/// a column holds no sample.
template <class Number>
LongEdge sideOfLongEdge(LongEdge ofTriangle, Interval rows, const Number &shortY,
                        const Number &longY)
{
    if (rows != Interval::Closed)
        return ofTriangle;
    if (longY < shortY)
        return LongEdge::Below;
    return shortY < longY ? LongEdge::Above : ofTriangle;
}

/// The row interval of the columns between the long edge and a short one.
constexpr Interval rowsBeside(const BoundaryRule &rule, LongEdge longEdge,
                              const SortedCorners &corners, const SortedEnds &shortEdge)
{
    const Lattice alongShort = corners[shortEdge[1]].y - corners[shortEdge[0]].y;
    const Lattice alongLong = corners[2].y - corners[0].y;
    return longEdge == LongEdge::Above ? rowsBetween(rule, alongShort, alongLong)
                                       : rowsBetween(rule, alongLong, alongShort);
}

/// Sets which rows a column covers between its bounds, and which of them the frame has.
template <class A, class Column, class View>
[[gnu::always_inline]] inline void coverRows(Column &column, Interval rows,
                                             const typename A::Number &low,
                                             const typename A::Number &high, const View &frame)
{
    column.firstRow = ownsFirst(rows) ? A::ceil(low) : A::floor(low) + 1;
    column.endRow = ownsLast(rows) ? A::floor(high) + 1 : A::ceil(high);
    column.firstDrawn = std::max<std::int64_t>(column.firstRow, frame.firstRow);
    column.endDrawn = std::min(column.endRow, frame.endRow());
}

} // namespace pixelplumb
