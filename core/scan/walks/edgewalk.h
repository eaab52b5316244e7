// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/rowwalk.h"
#include "core/scan/walks/columnscan.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace pixelplumb {

/// The column scan's set-up, with what readers of its numbers need of the triangle and the frame.
template <class A>
struct EdgeWalkSetUp {
    ColumnSetUp<A> scan;
    std::array<Vertex, 3> corners; ///< P0, P1, P2 as the frame sees them
    ScanIntervals intervals; ///< which bounds the fill rule includes
    std::int64_t firstOfFrame = 0; ///< the first sample along the frame's columns (or rows), px
};

template <class A>
struct EdgeWalkNumbers {
    using SetUp = EdgeWalkSetUp<A>;
    using Span = ColumnState<A>;
    using Sample = Fragment<A>;
};

/// Receives a column scan and reports it as an edge walk along the frame's columns or rows.
template <class A, SpanAxis axis, class Observer>
class EdgeWalkListener : public AxisListener<axis, Observer> {
public:
    EdgeWalkListener(const Triangle &triangle, ScanIntervals intervals, std::int64_t firstOfFrame,
                     Observer observer)
        : AxisListener<axis, Observer>(observer)
        , m_triangle(&triangle)
        , m_intervals(intervals)
        , m_firstOfFrame(firstOfFrame)
    {
    }

    void primitiveBegun(const ColumnSetUp<A> &setUp)
    {
        EdgeWalkSetUp<A> walk{setUp, {}, m_intervals, m_firstOfFrame};
        std::array<int, 3> &order = walk.scan.order;
        // betweenExtremes() has moved the middle vertex of a segment onto an end: it is still P1.
        if (this->isTurned && setUp.zeroArea)
            std::swap(order[1], *std::ranges::find(order, sortedByColumn(*m_triangle)[1]));
        for (std::size_t corner = 0; corner < 3; ++corner)
            walk.corners[corner] = m_triangle->vertices[std::size_t(order[corner])];
        this->m_observer.primitiveBegun(walk);
    }

private:
    const Triangle *m_triangle;
    ScanIntervals m_intervals;
    std::int64_t m_firstOfFrame;
};

template <class A, SpanAxis axis, class Observer>
inline constexpr bool readsNumbers<EdgeWalkListener<A, axis, Observer>> = readsNumbers<Observer>;

/// Walks a triangle's edges along the columns, or along the rows from the highest y to the lowest.
template <class A, SpanAxis axis, ScanObserver<EdgeWalkNumbers<A>> Observer>
void walkEdges(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
               Observer observer)
{
    using View = std::conditional_t<axis == SpanAxis::Row, TurnedView, FrameView>;
    const Triangle seen = axis == SpanAxis::Row ? betweenExtremes(triangle) : triangle;
    const Triangle scanned = axis == SpanAxis::Row ? turned(seen) : triangle;
    const View view(frame);
    const ScanIntervals intervals = axis == SpanAxis::Row ? rowIntervals({settings, frame})
                                                          : columnIntervals(settings.fillRule);
    const auto scan = [&](auto listener) {
        ColumnScan<A, decltype(listener), View>(scanned, intervals, settings.rounding, view,
                                                listener)
            .run();
    };
    if constexpr (std::is_same_v<Observer, NullObserver>)
        scan(observer); // nobody listens
    else
        scan(EdgeWalkListener<A, axis, Observer>(triangle, intervals, view.firstRow, observer));
}

} // namespace pixelplumb
