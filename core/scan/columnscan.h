// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/scan/columnstate.h"
#include "core/scan/edgewalker.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interval.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/variedscan.h"
#include "core/scan/workstage.h"

#include <algorithm>
#include <type_traits>

/// Column-wise scan conversion of a smoothly shaded triangle (Assignment (Borst), "The Triangle
/// Awakens"). Walk the columns from left to right; on each, the triangle is the interval from y_B
/// to y_T between two edges; colour its samples. Increments carry y and the colour of each edge
/// from column to column, and the colour from row to row. Each column computes anew which rows it
/// covers, the colour's increment (Δcolour/Δy, a division) and the colour of its first row. Each
/// edge starts anew at its first column.
///
/// This code draws traced and plain pictures. Untraced pictures in exact arithmetic and in float32
/// come from core/fast, whose kernels are tested to write the same bytes.
namespace pixelplumb {

/// Colours the rows of one column, bottom to top. It reads only the column's state, so that a
/// column can be drawn again, alone, with the same numbers.
template <class A, class View, class Observer>
[[gnu::always_inline]] inline void fillColumn(const ColumnState<A> &column, ByteRounding rounding,
                                              View frame, Observer observer)
{
    if (column.firstDrawnRow >= column.endDrawnRow)
        return;
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    Fragment<A> fragment;
    fragment.colour = column.firstColour;
    QRgb *pixel = frame.at(column.x, column.firstDrawnRow);
    for (std::int64_t row = column.firstDrawnRow; row < column.endDrawnRow; ++row) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            fragment.level[channel] = A::level(fragment.colour[channel], rounding);
        const QRgb after = pixelOfLevels(fragment.level);
        observer.pixelWritten(column.x, row, *pixel, after, fragment);
        *pixel = after;
        pixel += frame.stride;
        for (std::size_t channel = 0; channel < 3; ++channel)
            A::advance(fragment.colour[channel], column.colourRate[channel]);
    }
}

/// Scans one triangle into one frame under one fill rule. The view is a FrameView, or a turned
/// view, whose columns are the frame's rows. The form is RightScan, or a VariedScan with its
/// departures from the algorithm.
template <class A, ScanObserver<ColumnScanNumbers<A>> Observer, class View = FrameView,
          class Form = RightScan>
class ColumnScan {
public:
    ColumnScan(const Triangle &triangle, ScanIntervals intervals, ByteRounding rounding, View frame,
               Observer observer, Form form = {})
        : m_form(form)
        , m_intervals(intervals)
        , m_range(rangeOf(triangle, intervals.columns))
        , m_p0(triangle.vertices[std::size_t(m_range.order[0])])
        , m_p1(triangle.vertices[std::size_t(m_range.order[1])])
        , m_p2(triangle.vertices[std::size_t(m_range.order[2])])
        , m_ramp(m_p0, m_p1, m_p2)
        , m_rounding(rounding)
        , m_frame(frame)
        , m_observer(observer)
    {
    }

    [[gnu::always_inline]] void run()
    {
        if (!isRepresentable()) {
            m_observer.primitiveBegun(ColumnSetUp<A>{m_range, {}, {}});
            m_observer.primitiveRejected(PrimitiveRejection::NotRepresentable);
            return;
        }
        m_observer.primitiveBegun(setUp());
        if (m_range.zeroArea && m_intervals.columns != Interval::Closed) {
            m_observer.primitiveRejected(PrimitiveRejection::ZeroArea);
            return;
        }
        const std::int64_t first = std::max<std::int64_t>(m_range.firstColumn, m_frame.firstColumn);
        const std::int64_t end = std::min(m_range.endColumn, m_frame.endColumn());
        if (first >= end || isAboveOrBelowFrame()) {
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
            return;
        }
        if (m_range.zeroArea) {
            scanSegment(*this, first, end);
            return;
        }
        const std::int64_t middle = std::clamp(m_range.middleColumn, first, end);
        Walker longEdge = walker(m_p0, m_p2, first);
        scanHalf(ColumnHalf::First, first, middle, walker(m_p0, m_p1, first), longEdge);
        scanHalf(ColumnHalf::Second, middle, end, walker(m_p1, m_p2, middle), longEdge);
    }

private:
    using Ramp = typename Form::template Ramp<A>;
    static constexpr bool walksColours = Ramp::readsEdges || readsNumbers<Observer>;
    /// For triangles that have area.
    using Walker
        = EdgeWalker<A, std::conditional_t<walksColours, EdgeColours<A>, NoEdgeColours<A>>>;

    static ColumnRange rangeOf(const Triangle &triangle, Interval columns)
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

    bool isRepresentable() const
    {
        const auto isHeld
            = [](const Vertex &vertex) { return Form::template represents<A>(vertex.position); };
        return isHeld(m_p0) && isHeld(m_p1) && isHeld(m_p2);
    }

    [[gnu::always_inline]] Walker walker(const Vertex &a, const Vertex &b,
                                         std::int64_t column) const
    {
        const auto edge = m_form.edge(a, b);
        return Walker(edge.a, edge.b, column);
    }

    /// Includes the quotients that the walkers start with, if the observer reads numbers.
    ColumnSetUp<A> setUp() const
    {
        ColumnSetUp<A> setUp{m_range, {}, {}};
        if constexpr (readsNumbers<Observer>) {
            const std::array<std::array<const Vertex *, 2>, 3> edges
                = {{{&m_p0, &m_p1}, {&m_p1, &m_p2}, {&m_p0, &m_p2}}};
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const auto [a, b] = m_form.edge(*edges[edge][0], *edges[edge][1]);
                setUp.slope[edge] = A::edgeSlope(a, b);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    setUp.colourRate[edge][channel] = A::edgeColourRate(a, b, channel);
            }
        }
        return setUp;
    }

    /// Tests one vertex after another: usually the first one decides.
    bool isAboveOrBelowFrame() const
    {
        const auto all = [&](const auto &isThere) {
            return isThere(m_p0.position.y) && isThere(m_p1.position.y) && isThere(m_p2.position.y);
        };
        return all([&](Lattice y) { return y > (m_frame.endRow() - 1) * unitsPerPixel; })
            || all([&](Lattice y) { return y < m_frame.firstRow * unitsPerPixel; });
    }

    /// Zero area, closed rule: both bounds of every column are L₀₂. A vertical segment is the one
    /// column from P0 to P2, since its edges stay at their first vertices. Where x₀ = x₁ there is
    /// no first half.
    [[gnu::noinline]] static void scanSegment(ColumnScan scan, std::int64_t first, std::int64_t end)
    {
        const Vertex &p0 = scan.m_p0;
        const Vertex &p2 = scan.m_p2;
        EdgeWalker<A> longEdge(p0.position.x == p2.position.x ? p2 : p0, p2, first);
        const ColumnHalf half
            = p0.position.x == scan.m_p1.position.x ? ColumnHalf::Second : ColumnHalf::First;
        scan.scanHalf(half, first, end, EdgeWalker<A>(p0, p2, first), longEdge);
    }

    /// Scans the columns [first, end) between L₀₂ and the short edge of this half. L₀₂ is not
    /// restarted at x₁: it goes on adding its slope.
    template <class AnyWalker>
    [[gnu::always_inline]] void scanHalf(ColumnHalf half, std::int64_t first, std::int64_t end,
                                         AnyWalker shortEdge, AnyWalker &longEdge)
    {
        for (std::int64_t x = first; x < end; ++x) {
            [[maybe_unused]] const WorkScope span(m_observer, WorkStage::Span);
            scanColumn(half, x, shortEdge, longEdge);
            shortEdge.stepToNextColumn();
            longEdge.stepToNextColumn();
        }
    }

    /// The assignment has y_B ≤ y_T in each column: where rounding makes the edges cross, as it
    /// does near the last vertex, the column still reaches from one to the other. Under the other
    /// rules such a column holds no sample.
    template <class AnyWalker>
    LongEdge sideOfLongEdge(const AnyWalker &shortEdge, const AnyWalker &longEdge) const
    {
        if constexpr (Form::template boundsMayCross<A>) {
            const bool isClosed = m_intervals.rows == Interval::Closed;
            if (isClosed && Form::isBelow(longEdge.y, shortEdge.y))
                return LongEdge::Below;
            if (isClosed && Form::isBelow(shortEdge.y, longEdge.y))
                return LongEdge::Above;
        }
        return m_range.longEdge;
    }

    template <class AnyWalker>
    [[gnu::always_inline]] void scanColumn(ColumnHalf half, std::int64_t x,
                                           const AnyWalker &shortEdge, const AnyWalker &longEdge)
    {
        ColumnState<A> column;
        column.x = x;
        column.half = half;
        column.longEdge = sideOfLongEdge(shortEdge, longEdge);
        const bool longAbove = column.longEdge == LongEdge::Above;
        const AnyWalker &bottom = longAbove ? shortEdge : longEdge;
        const AnyWalker &top = longAbove ? longEdge : shortEdge;
        column.yBottom = bottom.y;
        column.yTop = top.y;
        bottom.showAt(column.colourBottom);
        top.showAt(column.colourTop);
        column.firstRow = ownsFirst(m_intervals.rows) ? A::ceil(bottom.y) : A::floor(bottom.y) + 1;
        column.endRow = ownsLast(m_intervals.rows) ? A::floor(top.y) + 1 : A::ceil(top.y);
        column.firstDrawnRow = std::max<std::int64_t>(column.firstRow, m_frame.firstRow);
        column.endDrawnRow = std::min(column.endRow, m_frame.endRow());
        column.colourRate = m_ramp.rates(column);
        column.firstColour = m_form.starts(m_ramp, column);
        m_observer.spanEntered(column);
        fillColumn(column, m_rounding, m_frame, m_observer);
    }

    [[no_unique_address]] Form m_form;
    ScanIntervals m_intervals;
    ColumnRange m_range;
    const Vertex &m_p0;
    const Vertex &m_p1;
    const Vertex &m_p2;
    Ramp m_ramp;
    ByteRounding m_rounding;
    View m_frame;
    Observer m_observer;
};

/// Scans a triangle under the fill rule of the settings.
template <class A, class Observer>
void scanColumns(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                 Observer observer)
{
    ColumnScan<A, Observer>(triangle, columnIntervals(settings.fillRule), settings.rounding, frame,
                            observer)
        .run();
}

} // namespace pixelplumb
