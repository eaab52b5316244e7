// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/scan/edgewalker.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/walks/columnwalk.h"
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
    if (column.firstDrawn >= column.endDrawn)
        return;
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    Fragment<A> fragment;
    fragment.colour = column.firstColour;
    QRgb *pixel = frame.at(column.x, column.firstDrawn);
    for (std::int64_t row = column.firstDrawn; row < column.endDrawn; ++row) {
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
/// view, whose columns are the frame's rows.
template <class A, ScanObserver<ColumnScanNumbers<A>> Observer, class View = FrameView>
class ColumnScan {
    using Ramp = typename A::ColourRamp;
    static constexpr bool walksColours = Ramp::readsEdges || readsNumbers<Observer>;
    /// For triangles that have area.
    using Walker
        = EdgeWalker<A, std::conditional_t<walksColours, EdgeColours<A>, NoEdgeColours<A>>>;

public:
    ColumnScan(const Triangle &triangle, ScanIntervals intervals, ByteRounding rounding, View frame,
               Observer observer)
        : m_intervals(intervals)
        , m_range(columnRangeOf(triangle, intervals.columns))
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
        walkTriangle(*this, m_range, m_intervals.columns, corners(), m_frame, m_observer);
    }

    /// What the walk asks for (columnwalk.h).
    static constexpr bool skipsEmptyHalf = false;
    [[gnu::always_inline]] Walker walkerOn(const SortedEnds &ends, std::int64_t column) const
    {
        return Walker(at(ends[0]), at(ends[1]), column);
    }
    Interval rowsOf(const SortedEnds &) const { return m_intervals.rows; }
    template <class AnyWalker>
    [[gnu::always_inline]] void scanColumn(ColumnHalf half, Interval rows, std::int64_t x,
                                           const AnyWalker &shortEdge, const AnyWalker &longEdge)
    {
        ColumnState<A> column;
        column.x = x;
        column.half = half;
        column.longEdge = m_range.longEdge;
        if constexpr (A::boundsMayCross)
            column.longEdge = sideOfLongEdge(column.longEdge, rows, shortEdge.y, longEdge.y);
        const bool longAbove = column.longEdge == LongEdge::Above;
        const AnyWalker &bottom = longAbove ? shortEdge : longEdge;
        const AnyWalker &top = longAbove ? longEdge : shortEdge;
        column.yBottom = bottom.y;
        column.yTop = top.y;
        bottom.showAt(column.colourBottom);
        top.showAt(column.colourTop);
        coverRows<A>(column, rows, bottom.y, top.y, m_frame);
        column.colourRate = m_ramp.rates(column);
        column.firstColour = m_ramp.starts(column, column.firstDrawn);
        m_observer.spanEntered(column);
        fillColumn(column, m_rounding, m_frame, m_observer);
    }

    [[gnu::noinline]] static void scanSegment(ColumnScan scan, const WalkedColumns &columns)
    {
        using Edge = EdgeWalker<A>;
        walkSegment(
            scan.corners(), columns, scan.m_observer,
            [&](const SortedEnds &ends, std::int64_t column) {
                return Edge(scan.at(ends[0]), scan.at(ends[1]), column);
            },
            [&](ColumnHalf half, std::int64_t x, const Edge &lower, const Edge &upper) {
                scan.scanColumn(half, scan.m_intervals.rows, x, lower, upper);
            });
    }

private:
    const Vertex &at(std::size_t corner) const
    {
        return corner == 0 ? m_p0 : corner == 1 ? m_p1 : m_p2;
    }
    SortedCorners corners() const { return {m_p0.position, m_p1.position, m_p2.position}; }

    bool isRepresentable() const
    {
        return A::represents(m_p0.position) && A::represents(m_p1.position)
            && A::represents(m_p2.position);
    }

    /// Includes the quotients that the walkers start with, if the observer reads numbers.
    ColumnSetUp<A> setUp() const
    {
        ColumnSetUp<A> setUp{m_range, {}, {}};
        if constexpr (readsNumbers<Observer>) {
            constexpr std::array<SortedEnds, 3> edges = {{{0, 1}, {1, 2}, {0, 2}}};
            for (std::size_t edge = 0; edge < 3; ++edge) {
                const Vertex &a = at(edges[edge][0]);
                const Vertex &b = at(edges[edge][1]);
                setUp.slope[edge] = A::edgeSlope(a, b);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    setUp.colourRate[edge][channel] = A::edgeColourRate(a, b, channel);
            }
        }
        return setUp;
    }

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
