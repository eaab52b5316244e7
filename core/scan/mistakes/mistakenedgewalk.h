// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/scan/mistakes/mistakenscan.h"
#include "core/scan/walks/edgewalk.h"

/// The mistaken scan as a kernel: it draws the settings' variants and bugs into a frame, and
/// announces them as an edge walk.
namespace pixelplumb {

/// What a walk in the arithmetic A computes in when it is mistaken.
template <class A>
struct MistakenValue {
    using Type = typename A::Number;
    static const Type &shown(const Type &value) { return value; }
};
template <class Integer>
struct MistakenValue<ExactArithmetic<Integer>> {
    using Type = Fraction;
    static MixedNumber<Integer> shown(const Type &value) { return mixedNumber(value); }
};
template <class A, class Value>
std::array<typename A::Number, 3> shown(const std::array<Value, 3> &values)
{
    return threeOf([&](std::size_t i) { return MistakenValue<A>::shown(values[i]); });
}

/// The triangle as a walk along columns, or along rows from the highest y to the lowest, has it.
template <SpanAxis axis>
WalkedTriangle walkedTriangleOf(const Triangle &triangle, const ScanSettings &settings,
                                FrameView frame)
{
    WalkedTriangle walked{triangle,       SpanOrder::Ascending, columnIntervals(settings.fillRule),
                          settings,       frame.firstColumn,    frame.endColumn(),
                          frame.firstRow, frame.endRow()};
    if constexpr (axis == SpanAxis::Row) {
        for (Vertex &vertex : walked.triangle.vertices)
            std::swap(vertex.position.x, vertex.position.y);
        std::swap(walked.firstSpan, walked.firstSample);
        std::swap(walked.endSpan, walked.endSample);
        walked.order = SpanOrder::Descending;
        const ScanIntervals intervals = rowIntervals({settings, frame});
        walked.intervals = {reversed(intervals.columns), intervals.rows};
    }
    return walked;
}

/// The triangle with the colours that its walk gives to the vertices.
inline Triangle walkedColours(const Triangle &triangle, const WalkedTriangle &walked)
{
    const ScanBugs &bugs = walked.settings.bugs;
    const SpanOrder order = orderOf(bugs, walked.order);
    const bool areUnsorted = bugs.vertexColours == VertexColours::AsGiven
        || variantsFrom(order, walked).contains(Variant::UnsortedColours);
    if (!areUnsorted)
        return triangle;
    return withUnsortedColours(triangle,
                               vertexOrderOf(seenFrom(walked, order).triangle, bugs.vertices));
}

/// Paints the spans of a mistaken scan, and announces them as those of a column scan.
template <class A, SpanAxis axis, class Observer>
class MistakenPainter {
public:
    static constexpr LevelDetail detail
        = readsNumbers<Observer> ? LevelDetail::Numbers : LevelDetail::Whole;

    MistakenPainter(const WalkedTriangle &triangle, FrameView frame, Observer observer)
        : m_triangle(triangle)
        , m_order(orderOf(triangle.settings.bugs, triangle.order))
        , m_frame(frame)
        , m_observer(observer)
    {
    }

    template <class Edge>
    void begun(const std::array<int, 3> &order, const std::array<std::int64_t, 3> &spans,
               const std::array<Edge, 3> &edges)
    {
        ColumnSetUp<A> setUp;
        setUp.order = order;
        const Triangle seen = seenFrom(m_triangle, m_order).triangle;
        const auto at
            = [&](std::size_t place) { return seen.vertices[std::size_t(order[place])].position; };
        setUp.longEdge = doubledArea(at(0), at(1), at(2)) >= 0 ? LongEdge::Above : LongEdge::Below;
        setUp.firstColumn = spans[0];
        setUp.middleColumn = spans[1];
        setUp.endColumn = spans[2];
        for (std::size_t edge = 0; edge < 3; ++edge) {
            setUp.slope[edge] = MistakenValue<A>::shown(edges[edge].slope());
            setUp.colourRate[edge] = shown<A>(edges[edge].colourRate());
        }
        m_observer.primitiveBegun(setUp);
    }

    static bool hears(std::int64_t) { return true; }
    template <class Numbers>
    bool walked(const MistakenSpan<Numbers> &span)
    {
        m_hasSpan = true;
        ColumnState<A> column;
        column.x = isTurned ? -span.span : span.span;
        if constexpr (detail == LevelDetail::Numbers) {
            column.half = span.half;
            column.longEdge = span.isLongAbove ? LongEdge::Above : LongEdge::Below;
            column.yBottom = MistakenValue<A>::shown(span.bounds.lower.place());
            column.yTop = MistakenValue<A>::shown(span.bounds.upper.place());
            column.colourBottom = shown<A>(span.bounds.lowerColours.colour());
            column.colourTop = shown<A>(span.bounds.upperColours.colour());
            column.colourRate = shown<A>(span.levels.step);
            column.firstRow = span.samples.first;
            column.endRow = span.samples.end;
            column.firstDrawn = std::max(span.samples.first, m_triangle.firstSample);
            column.endDrawn = std::min(span.samples.end, m_triangle.endSample);
            column.firstColour = shown<A>(span.levels.first);
            m_observer.spanEntered(column);
        }
        paint(column.x, span);
        return true;
    }

    /// Nothing was drawn, for this reason.
    void refuse(PrimitiveRejection reason)
    {
        ColumnSetUp<A> setUp;
        setUp.order = sortedByColumn(seenFrom(m_triangle, m_order).triangle);
        m_observer.primitiveBegun(setUp);
        m_observer.primitiveRejected(reason);
    }
    void end()
    {
        if (!m_hasSpan && detail == LevelDetail::Numbers)
            m_observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
    }

private:
    template <class Numbers>
    void paint(std::int64_t column, const MistakenSpan<Numbers> &span)
    {
        const bool wraps = m_triangle.settings.bugs.overflow == LevelOverflow::Wraps;
        for (std::size_t i = 0; i < span.levels.whole.size(); ++i) {
            Fragment<A> fragment;
            fragment.level = span.levels.whole[i];
            if (span.levels.hasNumbers)
                fragment.colour = shown<A>(span.levels.own[i]);
            for (std::int64_t &level : fragment.level)
                level = wraps ? std::uint8_t(level) : level;
            const std::int64_t row = span.samples.firstDrawn + std::int64_t(i);
            QRgb *const pixel = m_frame.at(column, row);
            const QRgb after = pixelOfLevels(fragment.level);
            m_observer.pixelWritten(column, row, *pixel, after, fragment);
            *pixel = after;
        }
    }

    using View = std::conditional_t<axis == SpanAxis::Row, TurnedView, FrameView>;

    const WalkedTriangle &m_triangle;
    const SpanOrder m_order;
    const bool isTurned = m_order != m_triangle.order; ///< seen from the method's other end
    View m_frame;
    Observer m_observer;
    bool m_hasSpan = false;
};

/// Like walkEdges(), with the variants and bugs of the settings. A triangle of zero area has none.
template <class A, SpanAxis axis, class Observer>
void walkMistakenEdges(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                       Observer observer)
{
    if (doubledArea(triangle) == 0) {
        walkEdges<A, axis>(triangle, settings, frame, observer);
        return;
    }
    const WalkedTriangle walked = walkedTriangleOf<axis>(triangle, settings, frame);
    const auto isBeside = [&](auto isThere) {
        return std::ranges::all_of(walked.triangle.vertices, [&](const Vertex &vertex) {
            return isThere(vertex.position.y);
        });
    };
    const bool isOutside = settings.bugs.isRight()
        && (isBeside([&](Lattice y) { return y > (walked.endSample - 1) * unitsPerPixel; })
            || isBeside([&](Lattice y) { return y < walked.firstSample * unitsPerPixel; }));
    const auto scan = [&](auto listener) {
        MistakenPainter<A, axis, decltype(listener)> painter(walked, frame, listener);
        if (isOutside)
            painter.refuse(PrimitiveRejection::OutsideFrame);
        else if (walkMistaken<MistakenNumbers<typename MistakenValue<A>::Type>>(
                     walked, settings.bugs, WalkSide(), painter))
            painter.end();
        else
            painter.refuse(PrimitiveRejection::NotRepresentable);
    };
    const Triangle coloured = walkedColours(triangle, walked);
    if constexpr (std::is_same_v<Observer, NullObserver>)
        scan(observer); // nobody listens
    else
        scan(EdgeWalkListener<A, axis, Observer>(
            coloured, axis == SpanAxis::Row ? rowIntervals({settings, frame}) : walked.intervals,
            walked.firstSample, observer));
}

} // namespace pixelplumb
