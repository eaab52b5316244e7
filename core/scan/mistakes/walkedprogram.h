// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/variededge.h"
#include "core/scan/mistakes/walkedtriangle.h"
#include "core/scan/mistakes/walkside.h"

#include <algorithm>
#include <vector>

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
inline Lattice wayToSpan(Lattice from, std::int64_t span, const ScanBugs &bugs, std::size_t channel)
{
    const bool hasPreStep = !bugs.withoutEdgePreStep.contains(channel);
    return (span - (hasPreStep ? 0 : ceilPixel(from))) * unitsPerPixel - (hasPreStep ? from : 0);
}

/// An edge as it is stepped: with the rates of an edge from a to b, starting at another position
/// and colour.
struct WalkedEdge {
    VariedEdge places, colours;
    Vertex firstPlace = places.a;
    Vertex firstColour = colours.a;
};

/// A program with everything that determines its picture.
class WalkedProgram {
public:
    /// The variants are the scene's, on all edges; coordinates of spans are seen from the end at
    /// which the walk begins.
    WalkedProgram(const ScanBugs &bugs, VariantSet variants, ByteRounding rounding, SpanOrder order,
                  const WalkSide &side)
        : m_bugs(withVariants(bugs, variants))
        , m_withRightEdges(m_bugs.withRightEdges())
        , m_changesOfAll(edgeChangesOf(variants))
        , m_rounding(rounding)
        , m_order(order)
        , m_side(side)
    {
    }
    // Edges keep references to this object's bugs.
    WalkedProgram(const WalkedProgram &) = delete;
    WalkedProgram &operator=(const WalkedProgram &) = delete;

    const ScanBugs &bugs() const { return m_bugs; }
    ByteRounding rounding() const { return m_rounding; }
    /// The span that a vertex's coordinate is rounded to.
    std::int64_t spanOf(Lattice coordinate) const
    {
        return m_bugs.spans == EndRounding::ByRule ? ceilPixel(coordinate)
                                                   : spanOf(coordinate, m_bugs.spans);
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
        return m_order == SpanOrder::Ascending ? m_bugs.leastSpan : m_bugs.greatestSpan;
    }
    SpanEnd lastEnd() const
    {
        return m_order == SpanOrder::Ascending ? m_bugs.greatestSpan : m_bugs.leastSpan;
    }
    const WalkSide &side() const { return m_side; }

    /// The bugs that apply to an edge.
    const ScanBugs &bugsOf(WalkedEdges edge) const
    {
        return m_bugs.departing == WalkedEdges::All || m_bugs.departing == edge ? m_bugs
                                                                                : m_withRightEdges;
    }
    WalkedEdge edge(WalkedEdges which, const Vertex &from, const Vertex &to) const
    {
        const ScanBugs &bugs = bugsOf(which);
        const auto divided = [&](EdgeRates rates) {
            const bool isDivided = bugs.divided == EdgeRates::All || bugs.divided == rates;
            EdgeChanges changes = bugs.edgeChanges;
            if (!isDivided)
                changes.bits &= edgechange::noPreStep.bits;
            VariedEdge edge = variedEdge(from, to, changes | m_changesOfAll);
            if (bugs.runEnds != Truncation::All && isDivided)
                edge.b.position.x = edge.a.position.x + wholeEnd(to) - wholeEnd(from);
            return edge;
        };
        WalkedEdge edge{
            withForm(shifted(divided(EdgeRates::Slope), bugs.placePreStep), bugs.slopeForm),
            withDivisor(shifted(divided(EdgeRates::Colours), bugs.edgeColourPreStep),
                        bugs.edgeColourDivisor)};
        if (bugs.edgeColourSign == EdgeColourSign::Negated)
            std::swap(edge.colours.a.colour, edge.colours.b.colour);
        return edge;
    }

private:
    static ScanBugs withVariants(ScanBugs bugs, VariantSet variants)
    {
        if (variants.contains(Variant::NoColourPreStep))
            bugs.spanPreStep = PreStep::None;
        if (variants.contains(Variant::UnsortedColours))
            bugs.vertexColours = VertexColours::AsGiven;
        return bugs;
    }
    /// (int)x of a vertex.
    Lattice wholeEnd(const Vertex &vertex) const
    {
        return spanOf(vertex.position.x, EndRounding::Down) * unitsPerPixel;
    }

    static VariedEdge withForm(VariedEdge edge, SlopeForm form)
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
    static VariedEdge withDivisor(VariedEdge edge, EdgeColourDivisor divisor)
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
    VariedEdge shifted(VariedEdge edge, PreStep preStep) const
    {
        const Lattice from = edge.a.position.x;
        const Lattice late = wholePixel(from, EndRounding::Up) * unitsPerPixel - from;
        Lattice way = 0;
        if (m_bugs.spans != EndRounding::ByRule)
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

    ScanBugs m_bugs, m_withRightEdges;
    EdgeChanges m_changesOfAll;
    ByteRounding m_rounding;
    SpanOrder m_order;
    const WalkSide &m_side;
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

/// What is kept of a span's levels: the whole ones, or the program's own numbers beside them.
enum class LevelDetail { Whole, Numbers };

/// The levels of a span's samples that lie in the frame.
template <class Number>
struct SpanLevels {
    SpanLevels(std::size_t samples, LevelDetail detail)
        : hasNumbers(detail == LevelDetail::Numbers)
        , whole(samples)
        , own(hasNumbers ? samples : 0)
    {
    }
    void reverse()
    {
        std::ranges::reverse(whole);
        std::ranges::reverse(own);
    }

    bool hasNumbers;
    std::vector<WholeLevels> whole;
    std::vector<std::array<Number, 3>> own; ///< before rounding, if they are kept
    std::array<Number, 3> first = {}; ///< at the first sample in the frame, or where it would be
    std::array<Number, 3> step = {}; ///< from sample to sample
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
    case EndRounding::AtZero:
        return 0;
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
