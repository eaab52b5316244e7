// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/walkedprogram.h"

#include <algorithm>

namespace pixelplumb {

/// The vertices that are taken for P₀ P₁ P₂.
std::array<int, 3> vertexOrderOf(const Triangle &triangle, VertexOrder vertices);

/// The triangle's spans from the first vertex to the last, in one kind of numbers.
template <class Numbers>
class Walking {
    using Edge = typename Numbers::Edge;

public:
    Walking(TriangleRuns &seen, const WalkedProgram &program)
        : m_seen(seen)
        , m_program(program)
        , m_walk(program.walk())
        , m_order(vertexOrderOf(seen.triangle, m_walk.vertices))
        , m_triangle(program.has(Variant::UnsortedColours)
                         ? withUnsortedColours(seen.triangle, m_order)
                         : seen.triangle)
        , m_p0(vertex(0))
        , m_p1(vertex(1))
        , m_p2(vertex(2))
    {
    }

    void run()
    {
        const Interval columns = m_seen.intervals.columns;
        const bool isByRule = m_program.spans() == EndRounding::ByRule;
        const std::int64_t firstSpan
            = isByRule ? firstSampleFrom(m_p0.position.x, columns) : wholeSpan(m_p0);
        const std::int64_t endSpan = isByRule ? endSampleAt(m_p2.position.x, columns)
                                              : wholeSpan(m_p2) + (ownsLast(columns) ? 1 : 0);
        const auto first = m_walk.remembers() ? firstSpan : std::max(firstSpan, m_seen.firstSpan);
        const auto end = std::min(endSpan, m_seen.endSpan);
        const bool isSorted
            = m_p0.position.x <= m_p1.position.x && m_p1.position.x <= m_p2.position.x;
        if (isSorted && first >= end)
            return;
        const auto ofBoth
            = [&](std::int64_t span) { return isSorted ? std::clamp(span, first, end) : span; };
        const std::int64_t middle = ofBoth(wholeSpan(m_p1));
        Edge across = edge(WalkedEdges::Long, longEdge(), first);
        Edge along = edge(WalkedEdges::First, firstEdge(), first);
        if (m_walk.longPlacesBefore == LongEdgeBefore::Waits)
            across.holdPlace();
        if (m_walk.longColoursBefore == LongEdgeBefore::Waits)
            across.holdColour();
        walkHalf(first, std::min(ofBoth(endOfFirstHalf()), m_seen.endSpan), along, across);
        goOnAcross(middle, across);
        Edge behind = edgeBehind(middle, along);
        if (m_p1.position.x == m_p2.position.x)
            endFlat(middle, along, behind, across);
        walkHalf(middle, end, behind, across);
    }

private:
    const Vertex &vertex(std::size_t place) const
    {
        return m_triangle.vertices[std::size_t(m_order[place])];
    }
    std::int64_t wholeSpan(const Vertex &vertex) const
    {
        return wholePixel(vertex.position.x, m_program.spans());
    }
    std::int64_t endOfFirstHalf() const
    {
        if (m_walk.middleSpan == MiddleSpan::InSecondHalf)
            return wholeSpan(m_p1);
        const bool isByRule = m_program.spans() == EndRounding::ByRule;
        return (isByRule ? floorPixel(m_p1.position.x) : wholeSpan(m_p1)) + 1;
    }

    /// Without one there is nothing that could be gone on with: L₁₂ is begun as it should be.
    bool hasFirstHalf() const { return m_p0.position.x != m_p1.position.x; }

    WalkedEdge firstEdge() const { return m_program.edge(WalkedEdges::First, m_p0, m_p1); }
    WalkedEdge secondEdge() const { return m_program.edge(WalkedEdges::Second, m_p1, m_p2); }
    WalkedEdge longEdge() const { return m_program.edge(WalkedEdges::Long, m_p0, m_p2); }
    Edge edge(WalkedEdges which, const WalkedEdge &edge, std::int64_t span) const
    {
        return Edge(edge, m_program.walkOf(which), span);
    }

    /// Between which vertices L₁₂ is taken to be for its slope or for the rates of its colours.
    static VariedScan::Edge rated(ShortRateBehind rate, VariedScan::Edge own,
                                  const VariedScan::Edge &ofFirst)
    {
        switch (rate) {
        case ShortRateBehind::Own:
            break;
        case ShortRateBehind::OfFirstEdge:
            return ofFirst;
        case ShortRateBehind::RiseFromFirst:
            own.a.position.y = ofFirst.a.position.y;
            own.a.colour = ofFirst.a.colour;
            break;
        case ShortRateBehind::RunFromFirst:
            own.a.position.x = ofFirst.a.position.x;
            break;
        }
        return own;
    }

    /// The short edge from the middle vertex on, where the one before it ends.
    Edge edgeBehind(std::int64_t middle, const Edge &before) const
    {
        WalkedEdge walked = secondEdge();
        const WalkedEdge ofFirst = firstEdge();
        if (hasFirstHalf()) {
            walked.places = rated(m_walk.shortSlopeBehind, walked.places, ofFirst.places);
            walked.colours = rated(m_walk.shortColourRatesBehind, walked.colours, ofFirst.colours);
        }
        if (m_walk.shortPlacesBehind == ShortEdgeBehind::FromFirst)
            walked.firstPlace.position.y = m_p0.position.y;
        if (m_walk.shortColoursBehind == ShortEdgeBehind::FromFirst)
            walked.firstColour.colour = m_p0.colour;
        Edge behind = edge(WalkedEdges::Second, walked, middle);
        if (hasFirstHalf() && m_walk.shortPlacesBehind == ShortEdgeBehind::CarriedOn)
            behind.carryPlaceOf(before);
        if (hasFirstHalf() && m_walk.shortColoursBehind == ShortEdgeBehind::CarriedOn)
            behind.carryColourOf(before);
        return behind;
    }

    void goOnAcross(std::int64_t middle, Edge &across) const
    {
        const Edge own = edge(WalkedEdges::Long, longEdge(), middle);
        across.stepAsPlacesOf(own);
        across.stepAsColoursOf(own);
        const auto begunAnew = [&](LongEdgeBehind behind) {
            const Vertex &from = behind == LongEdgeBehind::FromFirst ? m_p0 : m_p1;
            const WalkedEdge ofShort = secondEdge();
            WalkedEdge walked = longEdge();
            walked.firstPlace = ofShort.places.a;
            walked.firstPlace.position.y = from.position.y;
            walked.firstColour = ofShort.colours.a;
            walked.firstColour.colour = from.colour;
            return edge(WalkedEdges::Long, walked, middle);
        };
        const auto isBegunAnew = [](LongEdgeBehind behind) {
            return behind == LongEdgeBehind::FromMiddle || behind == LongEdgeBehind::FromFirst;
        };
        if (isBegunAnew(m_walk.longPlacesBehind))
            across.goOnWithPlacesOf(begunAnew(m_walk.longPlacesBehind));
        if (isBegunAnew(m_walk.longColoursBehind))
            across.goOnWithColoursOf(begunAnew(m_walk.longColoursBehind));
        if (m_walk.longPlacesBehind == LongEdgeBehind::Stands)
            across.holdPlace();
        if (m_walk.longColoursBehind == LongEdgeBehind::Stands)
            across.holdColour();
    }

    /// Of a triangle whose last two vertices share a span.
    void endFlat(std::int64_t middle, const Edge &before, Edge &behind, Edge &across) const
    {
        if (m_walk.flatEnd == FlatEnd::FromVertices) {
            const Edge last = edge(WalkedEdges::Second,
                                   m_program.edge(WalkedEdges::Second, m_p2, m_p2), middle);
            across.goOnWithPlacesOf(last);
            across.goOnWithColoursOf(last);
        }
        if (m_walk.flatEnd == FlatEnd::FromEdgesBefore) {
            behind.carryPlaceOf(before);
            behind.carryColourOf(before);
        }
    }

    void walkHalf(std::int64_t first, std::int64_t end, Edge &along, Edge &across)
    {
        const auto step = [&](Stepping stepping) {
            for (Edge *each : {&along, &across}) {
                if (m_walk.placeStepping == stepping)
                    each->stepPlace();
                if (m_walk.edgeColourStepping == stepping)
                    each->stepColour();
            }
        };
        for (std::int64_t span = first; span < end; ++span) {
            step(Stepping::BeforeDrawing);
            const bool isAcrossUpper = isUpper(across, along);
            const WalkedSpan samples
                = samplesOf(isAcrossUpper ? along : across, isAcrossUpper ? across : along);
            addSpan(span, samples, boundsOf(isAcrossUpper, along, across));
            const bool isEmpty = samples.first >= samples.end;
            if (!isEmpty || m_walk.emptySpans == EmptySpan::Steps)
                step(Stepping::AfterDrawing);
        }
    }

    bool isUpper(const Edge &across, const Edge &along) const
    {
        switch (m_walk.upperEdge) {
        case UpperEdge::TheUpper:
            break;
        case UpperEdge::Long:
            return true;
        case UpperEdge::Short:
            return false;
        case UpperEdge::LongIfBelowFirst:
            return m_p1.position.y < m_p0.position.y;
        case UpperEdge::LongIfBelowLast:
            return m_p1.position.y < m_p2.position.y;
        }
        // As in the scan: bounds that have passed each other change places where both are owned.
        const bool isClosed = m_seen.intervals.rows == Interval::Closed;
        if (isClosed && along.isBelow(across))
            return true;
        if (isClosed && across.isBelow(along))
            return false;
        return doubledArea(m_p0.position, m_p1.position, m_p2.position) >= 0;
    }

    typename Numbers::Bounds boundsOf(bool isAcrossUpper, const Edge &along,
                                      const Edge &across) const
    {
        const auto hasColoursOfAlong = [&] {
            switch (m_walk.lowerColours) {
            case LowerColours::OfItsEdge:
                break;
            case LowerColours::OfShortEdge:
                return true;
            case LowerColours::OfLongEdge:
                return false;
            case LowerColours::OfUpperEdge:
                return !isAcrossUpper;
            }
            return isAcrossUpper;
        }();
        return {isAcrossUpper ? along : across, isAcrossUpper ? across : along,
                hasColoursOfAlong ? along : across, hasColoursOfAlong ? across : along};
    }

    WalkedSpan samplesOf(const Edge &lower, const Edge &upper) const
    {
        const double inward = m_program.side().inward();
        const Interval rows = m_seen.intervals.rows;
        WalkedSpan samples{firstOf(Numbers::moved(lower, inward), m_walk.first, ownsFirst(rows))
                               - m_walk.extraBefore,
                           endOf(Numbers::moved(upper, -inward), m_walk.last, ownsLast(rows))
                               + m_walk.extraBehind};
        samples.firstDrawn = std::max(samples.first, m_seen.firstSample);
        samples.endDrawn = std::min(samples.end, m_seen.endSample);
        return samples;
    }

    void addSpan(std::int64_t span, const WalkedSpan &samples,
                 const typename Numbers::Bounds &bounds)
    {
        const bool isDrawn = span >= m_seen.firstSpan && span < m_seen.endSpan
            && samples.firstDrawn < samples.endDrawn;
        if (!isDrawn)
            return;
        const bool isReversed = m_walk.spanColours == SpanColours::FromLastSample;
        auto levels
            = Numbers::levelsOf(bounds, isReversed ? samples.reversed() : samples, m_program);
        if (isReversed)
            std::ranges::reverse(levels);
        m_seen.runs.push_back(
            {span, samples.firstDrawn, samples.endDrawn, std::move(levels), samples.firstDrawn});
    }

    TriangleRuns &m_seen;
    const WalkedProgram &m_program;
    const ProgramWalk &m_walk;
    std::array<int, 3> m_order;
    Triangle m_triangle;
    const Vertex &m_p0, &m_p1, &m_p2;
};

} // namespace pixelplumb
