// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/programwalk.h"

#include "core/grade/exactwalk.h"
#include "core/grade/roundedwalk.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// By rule: what belongs to the interval at this end.
template <class Edge>
std::int64_t firstOf(const Edge &lower, EndRounding rounding, Interval interval)
{
    switch (rounding) {
    case EndRounding::ByRule:
        break;
    case EndRounding::Down:
        return lower.floor();
    case EndRounding::Nearest:
        return lower.nearest();
    case EndRounding::Up:
        return lower.ceil();
    }
    return ownsFirst(interval) ? lower.ceil() : lower.floor() + 1;
}

template <class Edge>
std::int64_t endOf(const Edge &upper, EndRounding rounding, Interval interval)
{
    if (rounding != EndRounding::ByRule)
        return firstOf(upper, rounding, interval) + 1;
    return ownsLast(interval) ? upper.floor() + 1 : upper.ceil();
}

/// The triangle as a program sees it that goes through spans in ascending order.
TriangleRuns seenFrom(const TriangleRuns &triangle, WalkOrder order)
{
    TriangleRuns seen = triangle;
    seen.runs.clear();
    if (order == WalkOrder::Ascending)
        return seen;
    for (Vertex &vertex : seen.triangle.vertices)
        vertex.position.x = -vertex.position.x;
    seen.firstSpan = 1 - triangle.endSpan;
    seen.endSpan = 1 - triangle.firstSpan;
    seen.intervals.columns = reversed(triangle.intervals.columns);
    return seen;
}

/// The vertices that are taken for P₀ P₁ P₂.
std::array<int, 3> orderOf(const Triangle &triangle, VertexOrder vertices)
{
    if (vertices == VertexOrder::ByX)
        return sortedByColumn(triangle);
    std::array<int, 3> order = {0, 1, 2};
    if (vertices == VertexOrder::AsGiven)
        return order;
    const auto keyOf = [&](int index) {
        const LatticePoint &place = triangle.vertices[std::size_t(index)].position;
        if (vertices == VertexOrder::ByY)
            return LatticePoint{place.y, 0};
        return LatticePoint{place.x, vertices == VertexOrder::ByXThenDown ? -place.y : 0};
    };
    std::ranges::stable_sort(order, {}, keyOf);
    return order;
}

/// The triangle's spans from the first vertex to the last, in one kind of numbers.
template <class Numbers>
class Walking {
    using Edge = typename Numbers::Edge;

public:
    Walking(TriangleRuns &seen, const WalkedProgram &program)
        : m_seen(seen)
        , m_program(program)
        , m_walk(program.walk)
    {
    }

    void run()
    {
        const std::array<int, 3> order = orderOf(m_seen.triangle, m_walk.vertices);
        const Triangle triangle = m_program.departures.contains(Variant::UnsortedColours)
            ? withUnsortedColours(m_seen.triangle, order)
            : m_seen.triangle;
        const auto vertex = [&](std::size_t place) -> const Vertex & {
            return triangle.vertices[std::size_t(order[place])];
        };
        const Vertex &p0 = vertex(0);
        const Vertex &p1 = vertex(1);
        const Vertex &p2 = vertex(2);
        const Interval columns = m_seen.intervals.columns;
        const EndRounding spans = m_program.spans;
        const bool isByRule = spans == EndRounding::ByRule;
        const std::int64_t firstSpan
            = isByRule ? firstSampleFrom(p0.position.x, columns) : wholePixel(p0.position.x, spans);
        const std::int64_t endSpan = isByRule
            ? endSampleAt(p2.position.x, columns)
            : wholePixel(p2.position.x, spans) + (ownsLast(columns) ? 1 : 0);
        const auto first = m_walk.remembers() ? firstSpan : std::max(firstSpan, m_seen.firstSpan);
        const auto end = std::min(endSpan, m_seen.endSpan);
        const bool isSorted = p0.position.x <= p1.position.x && p1.position.x <= p2.position.x;
        if (isSorted && first >= end)
            return;
        const std::int64_t behind = wholePixel(p1.position.x, spans);
        const std::int64_t middle = isSorted ? std::clamp(behind, first, end) : behind;
        m_isLongUpper = doubledArea(p0.position, p1.position, p2.position) >= 0;
        const WalkedEdge ofLong = m_program.edge(p0, p2);
        Edge across(ofLong, m_walk, first);
        Edge along(m_program.edge(p0, p1), m_walk, first);
        walkHalf(first, std::min(middle, m_seen.endSpan), along, across);
        const WalkedEdge ofShort = m_program.behindMiddle().edge(p1, p2);
        goOnAcross(ofLong, ofShort, middle, across);
        Edge behindMiddle = edgeBehind(ofShort, p0, middle, along);
        if (p1.position.x == p2.position.x && m_walk.flatEnd == FlatEnd::FromVertices) {
            const Edge last(m_program.edge(p2, p2), m_walk, middle);
            across.goOnWithPlacesOf(last);
            across.goOnWithColoursOf(last);
        }
        if (p1.position.x == p2.position.x && m_walk.flatEnd == FlatEnd::FromEdgesBefore) {
            behindMiddle.carryPlaceOf(along);
            behindMiddle.carryColourOf(along);
        }
        walkHalf(middle, end, behindMiddle, across);
    }

private:
    /// The short edge from the middle vertex on, where the one before it ends.
    Edge edgeBehind(WalkedEdge edge, const Vertex &p0, std::int64_t middle, const Edge &before)
    {
        if (m_walk.shortPlacesBehind == ShortEdgeBehind::FromFirst)
            edge.firstPlace.position.y = p0.position.y;
        if (m_walk.shortColoursBehind == ShortEdgeBehind::FromFirst)
            edge.firstColour.colour = p0.colour;
        Edge behind(edge, m_walk, middle);
        if (m_walk.shortPlacesBehind == ShortEdgeBehind::CarriedOn)
            behind.carryPlaceOf(before);
        if (m_walk.shortColoursBehind == ShortEdgeBehind::CarriedOn)
            behind.carryColourOf(before);
        return behind;
    }

    void goOnAcross(WalkedEdge edge, const WalkedEdge &ofShort, std::int64_t middle, Edge &across)
    {
        edge.firstPlace = ofShort.places.a;
        edge.firstColour = ofShort.colours.a;
        const Edge anew(edge, m_walk, middle);
        if (m_walk.longPlacesBehind == LongEdgeBehind::FromMiddle)
            across.goOnWithPlacesOf(anew);
        if (m_walk.longColoursBehind == LongEdgeBehind::FromMiddle)
            across.goOnWithColoursOf(anew);
        if (m_walk.longPlacesBehind == LongEdgeBehind::Stands)
            across.holdPlace();
        if (m_walk.longColoursBehind == LongEdgeBehind::Stands)
            across.holdColour();
    }

    void walkHalf(std::int64_t first, std::int64_t end, Edge &along, Edge &across)
    {
        const auto step = [&] {
            along.stepToNextSpan();
            across.stepToNextSpan();
        };
        for (std::int64_t span = first; span < end; ++span) {
            if (m_walk.edgeStepping == Stepping::BeforeDrawing)
                step();
            // As in the scan: bounds that have passed each other change places where both are
            // owned.
            const bool isClosed = m_seen.intervals.rows == Interval::Closed;
            bool isAcrossUpper = m_isLongUpper;
            if (isClosed && across.isBelow(along))
                isAcrossUpper = false;
            if (isClosed && along.isBelow(across))
                isAcrossUpper = true;
            const WalkedSpan samples
                = samplesOf(isAcrossUpper ? along : across, isAcrossUpper ? across : along);
            addSpan(span, samples, boundsOf(isAcrossUpper, along, across));
            const bool isEmpty = samples.first >= samples.end;
            const bool waits = isEmpty && m_walk.emptySpans == EmptySpan::Waits;
            if (m_walk.edgeStepping == Stepping::AfterDrawing && !waits)
                step();
        }
    }

    typename Numbers::Bounds boundsOf(bool isAcrossUpper, const Edge &along,
                                      const Edge &across) const
    {
        const bool hasColoursOfAlong = m_walk.lowerColours == LowerColours::OfShortEdge
            || (m_walk.lowerColours == LowerColours::OfItsEdge && isAcrossUpper);
        return {isAcrossUpper ? along : across, isAcrossUpper ? across : along,
                hasColoursOfAlong ? along : across, hasColoursOfAlong ? across : along};
    }

    WalkedSpan samplesOf(const Edge &lower, const Edge &upper) const
    {
        const double inward = m_program.side.inward();
        const Interval rows = m_seen.intervals.rows;
        WalkedSpan samples{
            firstOf(Numbers::moved(lower, inward), m_walk.first, rows) - m_walk.extraBefore,
            endOf(Numbers::moved(upper, -inward), m_walk.last, rows) + m_walk.extraBehind};
        samples.firstDrawn = std::max(samples.first, m_seen.firstSample);
        samples.endDrawn = std::min(samples.end, m_seen.endSample);
        return samples;
    }

    void addSpan(std::int64_t span, const WalkedSpan &samples,
                 const typename Numbers::Bounds &bounds)
    {
        const bool isInFrame = span >= m_seen.firstSpan && span < m_seen.endSpan;
        if (isInFrame && samples.firstDrawn < samples.endDrawn)
            m_seen.runs.push_back({span, samples.firstDrawn, samples.endDrawn,
                                   Numbers::levelsOf(bounds, samples, m_program)});
    }

    TriangleRuns &m_seen;
    const WalkedProgram &m_program;
    const ProgramWalk &m_walk;
    bool m_isLongUpper = true;
};

/// Who goes from the other end has no departures along edges from the method's own.
VariantSet departuresOf(const TriangleRuns &triangle, WalkOrder order)
{
    VariantSet departures = triangle.settings.variants;
    for (const Variant variant : variantsAlongEdges) {
        if (order != triangle.order)
            departures = departures.without(variant);
    }
    return departures;
}

template <class Numbers>
void walkIn(TriangleRuns &triangle, const ProgramWalk &walk)
{
    const WalkOrder order = walk.order.value_or(triangle.order);
    TriangleRuns seen = seenFrom(triangle, order);
    const bool isHeld = std::ranges::all_of(seen.triangle.vertices, [&](const Vertex &vertex) {
        return Numbers::represents(vertex.position)
            && (!walk.remembers() || isNarrow(vertex.position));
    });
    if (!isHeld)
        return;
    const bool isSeenFromAbove = order == WalkOrder::Descending && walk.spans == EndRounding::Down;
    const WalkedProgram program{walk,
                                {departuresOf(triangle, order).bits | walk.departures.bits},
                                triangle.settings.rounding,
                                isSeenFromAbove ? EndRounding::Up : walk.spans,
                                triangle.side ? WalkSide(seen.triangle, *triangle.side)
                                              : WalkSide()};
    Walking<Numbers>(seen, program).run();
    triangle.runs = std::move(seen.runs);
    if (order == WalkOrder::Ascending)
        return;
    for (SampleRun &run : triangle.runs)
        run.span = -run.span;
    std::ranges::reverse(triangle.runs);
}

} // namespace

void walkAs(TriangleRuns &triangle, const ProgramWalk &walk)
{
    if (doubledArea(triangle.triangle) == 0)
        return;
    if (triangle.side)
        return walkIn<RoundedWalk<double>>(triangle, walk);
    switch (triangle.settings.arithmetic) {
    case Arithmetic::Exact:
        return walkIn<ExactWalk>(triangle, walk);
    case Arithmetic::Float32:
        return walkIn<RoundedWalk<float>>(triangle, walk);
    case Arithmetic::Float64:
        return walkIn<RoundedWalk<double>>(triangle, walk);
    case Arithmetic::Fixed16:
        return walkIn<RoundedWalk<FixedPoint16>>(triangle, walk);
    case Arithmetic::Fixed32:
        return walkIn<RoundedWalk<FixedPoint32>>(triangle, walk);
    }
}

std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk)
{
    return [walk](TriangleRuns &triangle) { walkAs(triangle, walk); };
}

} // namespace pixelplumb
