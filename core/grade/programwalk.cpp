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

/// The triangle's spans from the first vertex to the last, in one kind of numbers.
template <class Numbers>
class Walking {
    using Edge = typename Numbers::Edge;

public:
    Walking(TriangleRuns &seen, const WalkedProgram &program)
        : m_seen(seen)
        , m_program(program)
    {
    }

    void run()
    {
        const std::array<int, 3> order = sortedByColumn(m_seen.triangle);
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
        const auto first = std::max(firstSpan, m_seen.firstSpan);
        const auto end = std::min(endSpan, m_seen.endSpan);
        if (first >= end)
            return;
        const auto middle = std::clamp(wholePixel(p1.position.x, spans), first, end);
        m_isLongUpper = doubledArea(p0.position, p1.position, p2.position) >= 0;
        Edge across(p0, p2, m_program, first);
        walkHalf(first, middle, Edge(p0, p1, m_program, first), across);
        walkHalf(middle, end, Edge(p1, p2, m_program.behindMiddle(), middle), across);
    }

private:
    void walkHalf(std::int64_t first, std::int64_t end, Edge along, Edge &across)
    {
        for (std::int64_t span = first; span < end; ++span) {
            // As in the scan: bounds that have passed each other change places where both are
            // owned.
            const bool isClosed = m_seen.intervals.rows == Interval::Closed;
            bool isAcrossUpper = m_isLongUpper;
            if (isClosed && across.isBelow(along))
                isAcrossUpper = false;
            if (isClosed && along.isBelow(across))
                isAcrossUpper = true;
            addSpan(span, isAcrossUpper ? along : across, isAcrossUpper ? across : along);
            along.stepToNextSpan();
            across.stepToNextSpan();
        }
    }

    void addSpan(std::int64_t span, const Edge &lower, const Edge &upper)
    {
        const double inward = m_program.side.inward();
        WalkedSpan samples{
            firstOf(Numbers::moved(lower, inward), m_program.walk.first, m_seen.intervals.rows),
            endOf(Numbers::moved(upper, -inward), m_program.walk.last, m_seen.intervals.rows)};
        samples.firstDrawn = std::max(samples.first, m_seen.firstSample);
        samples.endDrawn = std::min(samples.end, m_seen.endSample);
        if (samples.firstDrawn < samples.endDrawn)
            m_seen.runs.push_back({span, samples.firstDrawn, samples.endDrawn,
                                   Numbers::levelsOf(lower, upper, samples, m_program)});
    }

    TriangleRuns &m_seen;
    const WalkedProgram &m_program;
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
    const bool isHeld = std::ranges::all_of(seen.triangle.vertices, [](const Vertex &vertex) {
        return Numbers::represents(vertex.position);
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
