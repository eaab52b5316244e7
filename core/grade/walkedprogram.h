// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"
#include "core/grade/walkside.h"
#include "core/scan/variedscan.h"

#include <algorithm>

namespace pixelplumb {

/// A coordinate rounded to px by ⌊ ⌋, to nearest or ⌈ ⌉; by the rule it is ⌈ ⌉.
constexpr std::int64_t wholePixel(Lattice coordinate, EndRounding rounding)
{
    if (rounding == EndRounding::Down)
        return floorPixel(coordinate);
    return rounding == EndRounding::Nearest ? floorPixel(coordinate + halfPixel)
                                            : ceilPixel(coordinate);
}

/// The distance from a position to a span, 1/256 px, over which a channel's colour is stepped:
/// without a pre-step the first span has the colour of the position.
inline Lattice wayToSpan(Lattice from, std::int64_t span, const ProgramWalk &walk,
                         std::size_t channel)
{
    const bool hasPreStep = !walk.withoutEdgePreStep.contains(channel);
    return (span - (hasPreStep ? 0 : ceilPixel(from))) * unitsPerPixel - (hasPreStep ? from : 0);
}

/// An edge as it is stepped: with the rates of an edge from a to b, starting at another position
/// and colour.
struct WalkedEdge {
    VariedScan::Edge places, colours;
    Vertex firstPlace = places.a;
    Vertex firstColour = colours.a;
};

/// A walk with everything that determines its picture.
class WalkedProgram {
public:
    /// The departures are the scene's; coordinates of spans are seen from the end at which the walk
    /// begins.
    WalkedProgram(const ProgramWalk &walk, VariantSet departures, ByteRounding rounding,
                  SpanOrder order, const WalkSide &side)
        : m_walk(walk)
        , m_withRightEdges(walk.withRightEdges())
        , m_departures(departures)
        , m_rounding(rounding)
        , m_order(order)
        , m_side(side)
    {
    }
    // Edges keep references to this object's walks.
    WalkedProgram(const WalkedProgram &) = delete;
    WalkedProgram &operator=(const WalkedProgram &) = delete;

    const ProgramWalk &walk() const { return m_walk; }
    ByteRounding rounding() const { return m_rounding; }
    /// The span that a vertex's coordinate is rounded to.
    std::int64_t spanOf(Lattice coordinate) const
    {
        return m_walk.spans == EndRounding::ByRule ? ceilPixel(coordinate)
                                                   : spanOf(coordinate, m_walk.spans);
    }
    /// The program's own coordinate rounded by ⌊ ⌋, to nearest or ⌈ ⌉, whichever way it walks.
    std::int64_t spanOf(Lattice coordinate, EndRounding rounding) const
    {
        return m_order == SpanOrder::Ascending ? wholePixel(coordinate, rounding)
                                               : -wholePixel(-coordinate, rounding);
    }
    /// How the first and the last span are chosen.
    SpanEnd firstEnd() const
    {
        return m_order == SpanOrder::Ascending ? m_walk.leastSpan : m_walk.greatestSpan;
    }
    SpanEnd lastEnd() const
    {
        return m_order == SpanOrder::Ascending ? m_walk.greatestSpan : m_walk.leastSpan;
    }
    const WalkSide &side() const { return m_side; }

    /// The walk that applies to an edge.
    const ProgramWalk &walkOf(WalkedEdges edge) const
    {
        return m_walk.departing == WalkedEdges::All || m_walk.departing == edge ? m_walk
                                                                                : m_withRightEdges;
    }
    WalkedEdge edge(WalkedEdges which, const Vertex &from, const Vertex &to) const
    {
        const ProgramWalk &walk = walkOf(which);
        const auto divided = [&](EdgeRates rates) {
            VariedScan::Edge edge = VariedScan{departuresOf(walk, rates)}.edge(from, to);
            const bool isOfWholeEnds = walk.runEnds != Truncation::All && isDivided(walk, rates);
            if (isOfWholeEnds)
                edge.b.position.x = edge.a.position.x + wholeEnd(to) - wholeEnd(from);
            return edge;
        };
        WalkedEdge edge{
            withForm(shifted(divided(EdgeRates::Slope), walk.placePreStep), walk.slopeForm),
            withDivisor(shifted(divided(EdgeRates::Colours), walk.edgeColourPreStep),
                        walk.edgeColourDivisor)};
        if (walk.edgeColourSign == EdgeColourSign::Negated)
            std::swap(edge.colours.a.colour, edge.colours.b.colour);
        return edge;
    }

    PreStep spanPreStep() const
    {
        return has(Variant::NoColourPreStep) ? PreStep::None : m_walk.spanPreStep;
    }
    bool has(Variant variant) const
    {
        return m_departures.contains(variant) || m_walk.departures.contains(variant);
    }

private:
    static bool isDivided(const ProgramWalk &walk, EdgeRates rates)
    {
        return walk.divided == EdgeRates::All || walk.divided == rates;
    }
    /// (int)x of a vertex.
    Lattice wholeEnd(const Vertex &vertex) const
    {
        return spanOf(vertex.position.x, EndRounding::Down) * unitsPerPixel;
    }
    VariantSet departuresOf(const ProgramWalk &walk, EdgeRates rates) const
    {
        VariantSet departures = walk.departures;
        if (!isDivided(walk, rates))
            departures
                = departures.without(Variant::DivisorMinusOne).without(Variant::DivisorPlusOne);
        departures.bits |= m_departures.bits;
        return departures;
    }

    static VariedScan::Edge withForm(VariedScan::Edge edge, SlopeForm form)
    {
        const LatticePoint &a = edge.a.position;
        LatticePoint &b = edge.b.position;
        if (form == SlopeForm::RunOverRise)
            b = {a.x + (b.y - a.y), a.y + (b.x - a.x)};
        if (form == SlopeForm::Negated)
            b.y = 2 * a.y - b.y;
        if (form == SlopeForm::OfMagnitude)
            b.y = a.y + absolute(b.y - a.y);
        return edge;
    }

    /// An edge along the spans has no step, whatever the divisor.
    static VariedScan::Edge withDivisor(VariedScan::Edge edge, EdgeColourDivisor divisor)
    {
        const LatticePoint &a = edge.a.position;
        LatticePoint &b = edge.b.position;
        const Lattice rise = b.y - a.y;
        if (divisor == EdgeColourDivisor::Run || a.x == b.x)
            return edge;
        b.x = a.x + (divisor == EdgeColourDivisor::Rise ? rise : absolute(rise));
        return edge;
    }

    /// Moves the edge so that its first span has the values that a wrong pre-step or span gives it.
    VariedScan::Edge shifted(VariedScan::Edge edge, PreStep preStep) const
    {
        const Lattice from = edge.a.position.x;
        const Lattice late = wholePixel(from, EndRounding::Up) * unitsPerPixel - from;
        Lattice way = 0;
        if (m_walk.spans != EndRounding::ByRule)
            way = spanOf(from) * unitsPerPixel - from;
        else if (preStep == PreStep::None)
            way = late;
        else if (preStep == PreStep::Backward)
            way = 2 * late;
        else if (preStep == PreStep::Fraction && late != 0)
            way = 2 * late - unitsPerPixel;
        edge.a.position.x += way;
        edge.b.position.x += way;
        return edge;
    }

    ProgramWalk m_walk, m_withRightEdges;
    VariantSet m_departures;
    ByteRounding m_rounding;
    SpanOrder m_order;
    WalkSide m_side;
};

/// The samples of a span; those to draw lie in the frame.
struct WalkedSpan {
    std::int64_t first = 0, end = 0;
    std::int64_t firstDrawn = 0, endDrawn = 0;

    std::int64_t samples() const { return std::max<std::int64_t>(0, end - first); }
    std::size_t drawn() const
    {
        return std::size_t(std::max<std::int64_t>(0, endDrawn - firstDrawn));
    }
    /// The span seen from its last sample.
    WalkedSpan reversed() const
    {
        return {first, end, first + end - endDrawn, first + end - firstDrawn};
    }
};

/// The first sample from a lower bound on; `owns` says whether the bound owns a sample on it.
template <class Edge>
std::int64_t firstOf(const Edge &lower, EndRounding rounding, bool owns)
{
    switch (rounding) {
    case EndRounding::ByRule:
        break;
    case EndRounding::OnBoundOtherwise:
        owns = !owns;
        break;
    case EndRounding::Down:
        return lower.floor();
    case EndRounding::Nearest:
        return lower.nearest();
    case EndRounding::Up:
        return lower.ceil();
    }
    return owns ? lower.ceil() : lower.floor() + 1;
}

/// One past the last sample before an upper bound.
template <class Edge>
std::int64_t endOf(const Edge &upper, EndRounding rounding, bool owns)
{
    const bool isOfBound
        = rounding == EndRounding::ByRule || rounding == EndRounding::OnBoundOtherwise;
    // By the rule the upper bound ends where a lower bound there would begin.
    return isOfBound ? firstOf(upper, rounding, !owns) : firstOf(upper, rounding, owns) + 1;
}

/// The two edges of a span, and the edges whose colours it takes at them.
template <class Edge>
struct WalkedBounds {
    const Edge &lower, &upper;
    const Edge &lowerColours, &upperColours;
};

} // namespace pixelplumb
