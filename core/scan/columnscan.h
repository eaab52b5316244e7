// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/scan/columnstate.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/interval.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

#include <algorithm>

/// Column-wise scan conversion of a smoothly shaded triangle (Assignment (Borst), "The Triangle
/// Awakens"). Walk the columns from left to right; on each, the triangle is the interval from y_B
/// to y_T between two edges; colour its samples. From column to column y and the colour of each
/// edge change by adding an increment, from row to row the colour does. What begins a column is
/// computed anew: which rows it covers, the colour's increment (Δcolour/Δy, a division) and the
/// colour of its first row. An edge is begun anew at its first column.
///
/// This is the traced and the plain drawing. Untraced pictures in exact arithmetic and in float32
/// come from core/fast, whose kernels are tested to write the same bytes.
namespace pixelplumb {

/// One edge under way: y and the colour where it meets the current column.
template <class A>
struct EdgeWalker {
    typename A::Number y;
    typename A::Number slope; ///< px per column
    std::array<typename A::Number, 3> colour; ///< levels
    std::array<typename A::Number, 3> colourRate; ///< levels per column

    /// The edge from a to b where it meets a column: at a itself, or after a pre-step when a lies
    /// between columns or outside the frame. A jump costs what a step costs.
    EdgeWalker(const Vertex &a, const Vertex &b, std::int64_t column)
        : y(A::edgeOrdinate(a, b, column))
        , slope(A::edgeSlope(a, b))
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            colour[channel] = A::edgeColour(a, b, channel, column);
            colourRate[channel] = A::edgeColourRate(a, b, channel);
        }
    }

    void stepToNextColumn()
    {
        A::advance(y, slope);
        for (std::size_t channel = 0; channel < 3; ++channel)
            A::advance(colour[channel], colourRate[channel]);
    }
};

/// Colours the rows of one column, bottom to top. The column's state is all it reads, so that a
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

/// The scan of one triangle into one frame under one rule. The view is a FrameView, or one that
/// shows a frame turned, so that its rows are scanned as columns.
template <class A, ScanObserver<ColumnScanNumbers<A>> Observer, class View = FrameView>
class ColumnScan {
public:
    ColumnScan(const Triangle &triangle, ScanIntervals intervals, ByteRounding rounding, View frame,
               Observer observer)
        : m_intervals(intervals)
        , m_setUp(setUpFor(triangle, intervals.columns))
        , m_p0(triangle.vertices[std::size_t(m_setUp.order[0])])
        , m_p1(triangle.vertices[std::size_t(m_setUp.order[1])])
        , m_p2(triangle.vertices[std::size_t(m_setUp.order[2])])
        , m_ramp(m_p0, m_p1, m_p2)
        , m_rounding(rounding)
        , m_frame(frame)
        , m_observer(observer)
    {
    }

    void run()
    {
        if (!isRepresentable()) {
            m_observer.primitiveBegun(m_setUp);
            m_observer.primitiveRejected(PrimitiveRejection::NotRepresentable);
            return;
        }
        computeRates();
        m_observer.primitiveBegun(m_setUp);
        if (m_setUp.zeroArea && m_intervals.columns != Interval::Closed) {
            m_observer.primitiveRejected(PrimitiveRejection::ZeroArea);
            return;
        }
        const std::int64_t first = std::max<std::int64_t>(m_setUp.firstColumn, m_frame.firstColumn);
        const std::int64_t end = std::min(m_setUp.endColumn, m_frame.endColumn());
        if (first >= end || isAboveOrBelowFrame()) {
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
            return;
        }
        if (m_setUp.zeroArea) {
            scanSegment(first, end);
            return;
        }
        const std::int64_t middle = std::clamp(m_setUp.middleColumn, first, end);
        EdgeWalker<A> longEdge(m_p0, m_p2, first);
        scanHalf(ColumnHalf::First, first, middle, EdgeWalker<A>(m_p0, m_p1, first), longEdge);
        scanHalf(ColumnHalf::Second, middle, end, EdgeWalker<A>(m_p1, m_p2, middle), longEdge);
    }

private:
    static ColumnSetUp<A> setUpFor(const Triangle &triangle, Interval columns)
    {
        ColumnSetUp<A> setUp;
        setUp.order = sortedByColumn(triangle);
        const auto position = [&](std::size_t corner) {
            return triangle.vertices[std::size_t(setUp.order[corner])].position;
        };
        const Int128 area = doubledArea(position(0), position(1), position(2));
        setUp.zeroArea = area == 0;
        setUp.longEdge = area >= 0 ? LongEdge::Above : LongEdge::Below;
        setUp.firstColumn = firstSampleFrom(position(0).x, columns);
        setUp.middleColumn = ceilPixel(position(1).x);
        setUp.endColumn = endSampleAt(position(2).x, columns);
        return setUp;
    }

    bool isRepresentable() const
    {
        return A::represents(m_p0.position) && A::represents(m_p1.position)
            && A::represents(m_p2.position);
    }

    void computeRates()
    {
        const std::array<std::array<const Vertex *, 2>, 3> edges
            = {{{&m_p0, &m_p1}, {&m_p1, &m_p2}, {&m_p0, &m_p2}}};
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const Vertex &a = *edges[edge][0];
            const Vertex &b = *edges[edge][1];
            m_setUp.slope[edge] = A::edgeSlope(a, b);
            for (std::size_t channel = 0; channel < 3; ++channel)
                m_setUp.colourRate[edge][channel] = A::edgeColourRate(a, b, channel);
        }
    }

    bool isAboveOrBelowFrame() const
    {
        const auto [lowest, highest]
            = std::minmax({m_p0.position.y, m_p1.position.y, m_p2.position.y});
        return ceilPixel(lowest) >= m_frame.endRow() || floorPixel(highest) < m_frame.firstRow;
    }

    /// Zero area, closed rule: both bounds of every column are L₀₂; a vertical segment, where every
    /// edge stays at its first vertex, is the one column from P0 to P2. Where x₀ = x₁ there is no
    /// first half.
    void scanSegment(std::int64_t first, std::int64_t end)
    {
        const Vertex &upper = m_p0.position.x == m_p2.position.x ? m_p2 : m_p0;
        EdgeWalker<A> longEdge(upper, m_p2, first);
        const ColumnHalf half
            = m_p0.position.x == m_p1.position.x ? ColumnHalf::Second : ColumnHalf::First;
        scanHalf(half, first, end, EdgeWalker<A>(m_p0, m_p2, first), longEdge);
    }

    /// The columns [first, end) between L₀₂ and the short edge of this half. L₀₂ is not started
    /// again at x₁: it goes on adding its slope.
    void scanHalf(ColumnHalf half, std::int64_t first, std::int64_t end, EdgeWalker<A> shortEdge,
                  EdgeWalker<A> &longEdge)
    {
        for (std::int64_t x = first; x < end; ++x) {
            [[maybe_unused]] const WorkScope span(m_observer, WorkStage::Span);
            scanColumn(half, x, shortEdge, longEdge);
            shortEdge.stepToNextColumn();
            longEdge.stepToNextColumn();
        }
    }

    /// The assignment has y_B ≤ y_T in each column: where rounding has taken the edges past each
    /// other, as it does near the last vertex, the column reaches from the one to the other all the
    /// same. Under the other rules such a column holds no sample.
    LongEdge sideOfLongEdge(const EdgeWalker<A> &shortEdge, const EdgeWalker<A> &longEdge) const
    {
        if constexpr (A::boundsMayCross) {
            const bool isClosed = m_intervals.rows == Interval::Closed;
            if (isClosed && longEdge.y < shortEdge.y)
                return LongEdge::Below;
            if (isClosed && shortEdge.y < longEdge.y)
                return LongEdge::Above;
        }
        return m_setUp.longEdge;
    }

    [[gnu::always_inline]] void scanColumn(ColumnHalf half, std::int64_t x,
                                           const EdgeWalker<A> &shortEdge,
                                           const EdgeWalker<A> &longEdge)
    {
        ColumnState<A> column;
        column.x = x;
        column.half = half;
        column.longEdge = sideOfLongEdge(shortEdge, longEdge);
        const bool longAbove = column.longEdge == LongEdge::Above;
        const EdgeWalker<A> &bottom = longAbove ? shortEdge : longEdge;
        const EdgeWalker<A> &top = longAbove ? longEdge : shortEdge;
        column.yBottom = bottom.y;
        column.yTop = top.y;
        column.colourBottom = bottom.colour;
        column.colourTop = top.colour;
        column.firstRow = ownsFirst(m_intervals.rows) ? A::ceil(bottom.y) : A::floor(bottom.y) + 1;
        column.endRow = ownsLast(m_intervals.rows) ? A::floor(top.y) + 1 : A::ceil(top.y);
        column.firstDrawnRow = std::max<std::int64_t>(column.firstRow, m_frame.firstRow);
        column.endDrawnRow = std::min(column.endRow, m_frame.endRow());
        for (std::size_t channel = 0; channel < 3; ++channel) {
            column.colourRate[channel] = m_ramp.rate(column, channel);
            column.firstColour[channel] = m_ramp.start(column, channel, column.firstDrawnRow);
        }
        m_observer.spanEntered(column);
        fillColumn(column, m_rounding, m_frame, m_observer);
    }

    ScanIntervals m_intervals;
    ColumnSetUp<A> m_setUp;
    const Vertex &m_p0;
    const Vertex &m_p1;
    const Vertex &m_p2;
    typename A::ColourRamp m_ramp;
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
