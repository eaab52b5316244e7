// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/columnstate.h"
#include "core/scan/mistakes/mistakennumbers.h"
#include "core/scan/mistakes/walkedends.h"

#include <algorithm>
#include <optional>

/// The scan of a program that walks along a triangle's edges, with its bugs (scanbugs.h): the
/// column scan (columnscan.h) for everything that a program may do otherwise. Without bugs and
/// variants it draws what the column scan draws.
namespace pixelplumb {

/// A span that the program has walked, seen from where it begins.
template <class Numbers>
struct MistakenSpan {
    std::int64_t span = 0;
    ColumnHalf half = ColumnHalf::First;
    bool isLongAbove = false;
    bool isFinal = false; ///< nothing paints over it later
    WalkedSpan samples;
    const typename Numbers::Bounds &bounds;
    SpanLevels<typename Numbers::Number> &levels; ///< of the samples to be drawn; may be taken
};

/// Walks a triangle's spans from the first vertex to the last, in one number type. The receiver has
///   detail                     what it reads of a span's levels;
///   begun(order, spans, edges) what is computed once, if it reads numbers;
///   hears(span)                whether it asks for that span of the frame;
///   walked(span)               a span that it hears; false ends the walk.
template <class Numbers, class Receiver>
class MistakenScan {
    using Edge = typename Numbers::Edge;

public:
    MistakenScan(const WalkedTriangle &seen, const WalkedProgram &program, Receiver &receiver)
        : m_seen(seen)
        , m_program(program)
        , m_receiver(receiver)
        , m_bugs(program.bugs())
        , m_corners(seen.triangle, program)
        , m_ends(m_corners, program, seen.intervals.columns)
        , m_p0(m_corners.p0())
        , m_p1(m_corners.p1())
        , m_p2(m_corners.p2())
    {
    }

    void run()
    {
        const std::int64_t firstSpan = m_ends.firstOfTriangle();
        const std::int64_t endSpan = m_ends.endOfTriangle();
        const auto first = m_bugs.remembers() ? firstSpan : std::max(firstSpan, m_seen.firstSpan);
        const auto end = std::min(endSpan, m_seen.endSpan);
        if constexpr (Receiver::detail == LevelDetail::Numbers)
            announce({firstSpan, m_ends.firstOfSecondHalf(), endSpan});
        const bool isSorted = m_corners.areSorted();
        if (isSorted && first >= end)
            return;
        const auto ofBoth
            = [&](std::int64_t span) { return isSorted ? std::clamp(span, first, end) : span; };
        const std::int64_t middle
            = m_ends.isBegunBeforeMiddle() ? first : ofBoth(m_ends.firstOfSecondHalf());
        Edge across = edge(WalkedEdges::Long, m_corners.longEdge(), first);
        Edge along = edge(WalkedEdges::First, m_corners.firstEdge(), first);
        if (m_bugs.longPlacesBefore == LongEdgeBefore::Waits)
            across.holdPlace();
        if (m_bugs.longColoursBefore == LongEdgeBefore::Waits)
            across.holdColour();
        m_endFinal = middle;
        walkHalf(ColumnHalf::First, first,
                 std::min(ofBoth(m_ends.endOfFirstHalf()), m_seen.endSpan), along, across);
        goOnAcross(middle, across);
        Edge behind = edgeBehind(middle, along);
        if (m_p1.position.x == m_p2.position.x)
            endFlat(middle, along, behind, across);
        if (m_bugs.spanStart == SpanStart::GoesOnInHalf)
            m_carried.reset();
        m_endFinal = end;
        walkHalf(ColumnHalf::Second, middle, end, behind, across);
    }

private:
    /// The spans: the first, the first of the second half, and one past the last.
    void announce(const std::array<std::int64_t, 3> &spans) const
    {
        const std::array<Edge, 3> edges
            = {edge(WalkedEdges::First, m_corners.firstEdge(), spans[0]),
               edge(WalkedEdges::Second, m_corners.secondEdge(), spans[0]),
               edge(WalkedEdges::Long, m_corners.longEdge(), spans[0])};
        m_receiver.begun(m_corners.order(), spans, edges);
    }
    Edge edge(WalkedEdges which, const WalkedEdge &edge, std::int64_t span) const
    {
        return Edge(edge, m_program.bugsOf(which), span);
    }

    /// The second short edge, from the middle vertex on, where the first one ends.
    Edge edgeBehind(std::int64_t middle, const Edge &before) const
    {
        WalkedEdge walked = m_corners.secondEdge();
        if (m_bugs.shortPlacesBehind == ShortEdgeBehind::FromFirst)
            walked.firstPlace.position.y = m_p0.position.y;
        if (m_bugs.shortColoursBehind == ShortEdgeBehind::FromFirst)
            walked.firstColour.colour = m_p0.colour;
        Edge behind = edge(WalkedEdges::Second, walked, middle);
        if (m_corners.hasFirstHalf() && m_bugs.shortPlacesBehind == ShortEdgeBehind::CarriedOn)
            behind.carryPlaceOf(before);
        if (m_corners.hasFirstHalf() && m_bugs.shortColoursBehind == ShortEdgeBehind::CarriedOn)
            behind.carryColourOf(before);
        return behind;
    }

    void goOnAcross(std::int64_t middle, Edge &across) const
    {
        const Edge own = edge(WalkedEdges::Long, m_corners.longEdge(), middle);
        across.stepAsPlacesOf(own);
        across.stepAsColoursOf(own);
        const auto begunAnew = [&](LongEdgeBehind behind) {
            if (behind == LongEdgeBehind::WithoutPreStep)
                return edge(WalkedEdges::Long, m_corners.longEdgeWithoutPreStep(), middle);
            const Vertex &from = behind == LongEdgeBehind::FromFirst ? m_p0 : m_p1;
            const WalkedEdge ofShort = m_program.edge(WalkedEdges::Second, m_p1, m_p2);
            WalkedEdge walked = m_corners.longEdge();
            walked.firstPlace = ofShort.firstPlace;
            walked.firstPlace.position.y = from.position.y;
            walked.firstColour = ofShort.firstColour;
            walked.firstColour.colour = from.colour;
            return edge(WalkedEdges::Long, walked, middle);
        };
        if (isBegunAnew(m_bugs.longPlacesBehind))
            across.goOnWithPlacesOf(begunAnew(m_bugs.longPlacesBehind));
        if (isBegunAnew(m_bugs.longColoursBehind))
            across.goOnWithColoursOf(begunAnew(m_bugs.longColoursBehind));
        if (m_bugs.longPlacesBehind == LongEdgeBehind::Stands)
            across.holdPlace();
        if (m_bugs.longColoursBehind == LongEdgeBehind::Stands)
            across.holdColour();
    }

    /// Handles a triangle whose last two vertices share a span.
    void endFlat(std::int64_t middle, const Edge &before, Edge &behind, Edge &across) const
    {
        if (m_bugs.flatEnd == FlatEnd::FromVertices) {
            const Edge last = edge(WalkedEdges::Second,
                                   m_program.edge(WalkedEdges::Second, m_p2, m_p2), middle);
            across.goOnWithPlacesOf(last);
            across.goOnWithColoursOf(last);
        }
        if (m_bugs.flatEnd == FlatEnd::FromEdgesBefore) {
            behind.carryPlaceOf(before);
            behind.carryColourOf(before);
        }
    }

    void walkHalf(ColumnHalf half, std::int64_t first, std::int64_t end, Edge &along, Edge &across)
    {
        const auto step = [&](Stepping stepping) {
            for (Edge *each : {&along, &across}) {
                if (m_bugs.placeStepping == stepping)
                    each->stepPlace();
                if (m_bugs.edgeColourStepping == stepping)
                    each->stepColour();
            }
        };
        const bool arePassed
            = m_bugs.spanStart == SpanStart::AtBound && m_bugs.emptySpans == EmptySpan::Steps;
        for (std::int64_t span = first; span < end && !m_hasEnded; ++span) {
            step(Stepping::BeforeDrawing);
            if (arePassed && !m_receiver.hears(span)) {
                step(Stepping::AfterDrawing);
                continue;
            }
            const bool isAcrossUpper = isUpper(across, along);
            const WalkedSpan samples
                = samplesOf(isAcrossUpper ? along : across, isAcrossUpper ? across : along);
            addSpan(half, span, samples, isAcrossUpper, boundsOf(isAcrossUpper, along, across));
            const bool isEmpty = samples.first >= samples.end;
            if (!isEmpty || m_bugs.emptySpans == EmptySpan::Steps)
                step(Stepping::AfterDrawing);
        }
    }

    bool isUpper(const Edge &across, const Edge &along) const
    {
        switch (m_bugs.upperEdge) {
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
        case UpperEdge::LongBySlopes:
            return m_corners.isFirstEdgeFlatter();
        }
        // As in the scan: bounds that have crossed are swapped where both are owned.
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
            switch (m_bugs.lowerColours) {
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
        WalkedSpan samples{firstOf(Numbers::moved(lower, inward), m_bugs.first, ownsFirst(rows))
                               - m_bugs.extraBefore,
                           endOf(Numbers::moved(upper, -inward), m_bugs.last, ownsLast(rows))
                               + m_bugs.extraBehind};
        samples.firstDrawn = std::max(samples.first, m_seen.firstSample);
        samples.endDrawn = std::min(samples.end, m_seen.endSample);
        return samples;
    }

    void addSpan(ColumnHalf half, std::int64_t span, const WalkedSpan &samples, bool isAcrossUpper,
                 const typename Numbers::Bounds &bounds)
    {
        const bool isInFrame
            = span >= m_seen.firstSpan && span < m_seen.endSpan && m_receiver.hears(span);
        const bool isDrawn = isInFrame && samples.firstDrawn < samples.endDrawn;
        const bool isHeard = isDrawn || (isInFrame && Receiver::detail == LevelDetail::Numbers);
        if (!isHeard && m_bugs.spanStart == SpanStart::AtBound)
            return;
        const bool isReversed = m_bugs.spanColours == SpanColours::FromLastSample;
        SpanLevels<typename Numbers::Number> levels(samples.drawn(), Receiver::detail);
        Numbers::fill(levels, bounds, isReversed ? samples.reversed() : samples, m_program,
                      m_carried);
        if (!isHeard)
            return;
        if (isReversed)
            levels.reverse();
        m_hasEnded = !m_receiver.walked(MistakenSpan<Numbers>{
            span, half, isAcrossUpper, span < m_endFinal, samples, bounds, levels});
    }

    const WalkedTriangle &m_seen;
    const WalkedProgram &m_program;
    Receiver &m_receiver;
    const ScanBugs &m_bugs;
    WalkCorners m_corners;
    WalkedEnds m_ends;
    const Vertex &m_p0, &m_p1, &m_p2;
    bool m_hasEnded = false;
    std::int64_t m_endFinal = 0; ///< earlier spans of the current half are painted only once
    std::optional<typename Numbers::Carried> m_carried; ///< where the next span goes on
};

/// Walks the triangle; false, with nothing drawn, for one without area, beyond the numbers' range
/// or, in exact numbers or where the program remembers earlier spans, beyond 2^15 px.
template <class Numbers, class Receiver>
bool walkMistaken(const WalkedTriangle &triangle, const ScanBugs &bugs, const WalkSide &side,
                  Receiver &receiver)
{
    const SpanOrder order = orderOf(bugs, triangle.order);
    const WalkedTriangle seen = seenFrom(triangle, order);
    const bool isHeld = std::ranges::all_of(seen.triangle.vertices, [&](const Vertex &vertex) {
        return Numbers::represents(vertex.position)
            && (!bugs.remembers() || isNarrow(vertex.position));
    });
    if (!isHeld || doubledArea(seen.triangle) == 0)
        return false;
    const WalkedProgram program(bugs, variantsFrom(order, triangle), triangle.settings.rounding,
                                order, side);
    MistakenScan<Numbers, Receiver>(seen, program, receiver).run();
    return true;
}

} // namespace pixelplumb
