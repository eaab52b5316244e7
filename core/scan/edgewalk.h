// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/columnscan.h"
#include "core/scan/rowwalk.h"
#include "core/trace/tracerecords.h"

#include <optional>
#include <type_traits>

namespace pixelplumb {

/// How the positions of the edges and their colours come about.
enum class WalkForm {
    Accumulated, ///< each span adds the slopes to the one before
    Direct, ///< each span computes y₀ + (x − x₀)·m anew
};

/// The column scan's set-up and the triangle's corners as the frame sees them, in sorted order.
template <class A>
struct EdgeWalkSetUp {
    ColumnSetUp<A> scan;
    std::array<Vertex, 3> corners;
};

/// One of the two edges that bound a span.
template <class A>
struct WalkedEdge {
    using Number = typename A::Number;

    Number slope = {}; ///< px for each span
    std::array<Number, 3> colourRate = {}; ///< levels for each span
    /// Where the edge comes from: its vertex, or the span before. Across the spans in lattice units
    /// and along the span in px.
    Lattice fromAcross = 0;
    Number fromAlong = {};
    std::array<Number, 3> fromColour = {}; ///< levels
};

/// A column scan's span with the edges that bound it.
template <class A>
struct EdgeWalkSpan {
    ColumnState<A> column;
    WalkedEdge<A> lower, upper;
};

template <class A>
struct EdgeWalkNumbers {
    using SetUp = EdgeWalkSetUp<A>;
    using Span = EdgeWalkSpan<A>;
    using Sample = Fragment<A>;
};

/// Hears a column scan and tells it on as an edge walk along the columns or rows of the frame.
template <class A, SpanAxis axis, class Observer>
class EdgeWalkListener {
public:
    EdgeWalkListener(const Triangle &triangle, const Triangle &scanned, WalkForm form,
                     Observer observer)
        : m_triangle(&triangle)
        , m_scanned(&scanned)
        , m_form(form)
        , m_observer(observer)
    {
    }

    void primitiveBegun(const ColumnSetUp<A> &setUp)
    {
        if constexpr (isHeard) {
            m_setUp = &setUp;
            EdgeWalkSetUp<A> walk{setUp, {}};
            for (std::size_t corner = 0; corner < 3; ++corner)
                walk.corners[corner] = m_triangle->vertices[std::size_t(setUp.order[corner])];
            m_observer.primitiveBegun(walk);
        }
    }
    void primitiveRejected(PrimitiveRejection reason) { m_observer.primitiveRejected(reason); }
    void spanEntered(const ColumnState<A> &column)
    {
        if constexpr (isHeard) {
            const bool longAbove = m_setUp->longEdge == LongEdge::Above;
            EdgeWalkSpan<A> span;
            span.column = column;
            span.lower = edge(column, longAbove ? Side::Short : Side::Long);
            span.upper = edge(column, longAbove ? Side::Long : Side::Short);
            if (m_previous && continues(column, longAbove ? Side::Short : Side::Long))
                comeFrom(span.lower, m_previous->yBottom, m_previous->colourBottom);
            if (m_previous && continues(column, longAbove ? Side::Long : Side::Short))
                comeFrom(span.upper, m_previous->yTop, m_previous->colourTop);
            m_previous = column;
            m_observer.spanEntered(span);
        }
    }
    void sampleRejected(std::int64_t u, std::int64_t v, QRgb pixel, const Fragment<A> &fragment)
    {
        m_observer.sampleRejected(x(u, v), y(u, v), pixel, fragment);
    }
    void pixelWritten(std::int64_t u, std::int64_t v, QRgb before, QRgb after,
                      const Fragment<A> &fragment)
    {
        m_observer.pixelWritten(x(u, v), y(u, v), before, after, fragment);
    }

private:
    static constexpr bool isHeard = !std::is_same_v<Observer, NullObserver>;
    static constexpr bool isTurned = axis == SpanAxis::Row;
    enum class Side { Short, Long };

    static std::int64_t x(std::int64_t u, std::int64_t v) { return isTurned ? v : u; }
    static std::int64_t y(std::int64_t u, std::int64_t v) { return isTurned ? -u : v; }

    const Vertex &scannedCorner(std::size_t corner) const
    {
        return m_scanned->vertices[std::size_t(m_setUp->order[corner])];
    }

    /// L₀₂ goes on through the middle vertex; a short edge does not.
    bool continues(const ColumnState<A> &column, Side side) const
    {
        return m_form == WalkForm::Accumulated
            && (side == Side::Long || m_previous->half == column.half);
    }

    /// A segment across the spans lies in one of them, from P0 to P2.
    std::size_t startOf(SortedEdge edge, Side side) const
    {
        const bool isAcross = scannedCorner(0).position.x == scannedCorner(2).position.x;
        if (m_setUp->zeroArea && isAcross && side == Side::Long)
            return 2;
        return edge == SortedEdge::L12 ? 1 : 0;
    }

    WalkedEdge<A> edge(const ColumnState<A> &column, Side side) const
    {
        const bool isFirst = column.half == ColumnHalf::First;
        const bool isLong = side == Side::Long || m_setUp->zeroArea;
        const SortedEdge sorted
            = isLong ? SortedEdge::L02 : (isFirst ? SortedEdge::L01 : SortedEdge::L12);
        const Vertex &vertex = scannedCorner(startOf(sorted, side));
        WalkedEdge<A> walked;
        walked.slope = m_setUp->slope[std::size_t(sorted)];
        walked.colourRate = m_setUp->colourRate[std::size_t(sorted)];
        walked.fromAcross = vertex.position.x;
        // An edge from a vertex to itself stays there.
        walked.fromAlong = A::edgeOrdinate(vertex, vertex, column.x);
        for (std::size_t channel = 0; channel < 3; ++channel)
            walked.fromColour[channel] = A::edgeColour(vertex, vertex, channel, column.x);
        return walked;
    }

    void comeFrom(WalkedEdge<A> &edge, const typename A::Number &along,
                  const std::array<typename A::Number, 3> &colour) const
    {
        edge.fromAcross = m_previous->x * unitsPerPixel;
        edge.fromAlong = along;
        edge.fromColour = colour;
    }

    const Triangle *m_triangle;
    const Triangle *m_scanned;
    WalkForm m_form;
    Observer m_observer;
    const ColumnSetUp<A> *m_setUp = nullptr;
    std::optional<ColumnState<A>> m_previous;
};

/// Walks a triangle's edges along the columns, or along the rows from the top down.
template <class A, SpanAxis axis, ScanObserver<EdgeWalkNumbers<A>> Observer>
void walkEdges(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
               WalkForm form, Observer observer)
{
    using Listener = EdgeWalkListener<A, axis, Observer>;
    using View = std::conditional_t<axis == SpanAxis::Row, TurnedView, FrameView>;
    const Triangle scanned = axis == SpanAxis::Row ? turned(triangle) : triangle;
    const Listener listener(triangle, scanned, form, observer);
    if (settings.fillRule == FillRule::Closed)
        ColumnScan<A, FillRule::Closed, Listener, View>(scanned, settings.rounding, View(frame),
                                                        listener)
            .run();
    else
        ColumnScan<A, FillRule::HalfOpenColumn, Listener, View>(scanned, settings.rounding,
                                                                View(frame), listener)
            .run();
}

} // namespace pixelplumb
