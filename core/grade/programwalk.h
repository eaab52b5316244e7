// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"
#include "core/grade/walkside.h"
#include "core/scan/variedscan.h"

namespace pixelplumb {

/// What is kept of a number: all, or what is left of it where it is divided or stored as a whole
/// one, in C (toward 0), by Python's // (down) or by round().
enum class Kept { All, TowardZero, Down, Nearest };
/// How far a first value lies from where it is known: a vertex' first span ⌈x₀⌉ − x₀ from it, a
/// bound's first sample ⌈y_B⌉ − y_B; nothing; x₀ − ⌊x₀⌋; or the right way in the wrong direction.
enum class PreStep { ToSample, None, Fraction, Backward };
/// When what is stepped is stepped.
enum class Stepping { AfterDrawing, BeforeDrawing };
/// What happens to the edges at a span without samples.
enum class EmptySpan { Steps, Waits };
/// To which sample a bound of a span is taken: what the fill rule says, ⌊ ⌋, the nearest, ⌈ ⌉.
enum class EndRounding { ByRule, Down, Nearest, Up };
/// By what a span's difference of colours is divided: y_T − y_B; this and one; the number of its
/// samples; or the steps from its first sample to its last. By 0 nothing is, and nothing stepped.
enum class SpanDivisor { Height, HeightAndOne, Samples, Steps };
/// Whose colours are taken for the lower bound's: its own edge's, or always those of the short edge
/// or of the long one, the other bound having the other's.
enum class LowerColours { OfItsEdge, OfShortEdge, OfLongEdge };
/// With what L₁₂ begins: with P₁'s own, with P₀'s, or with what L₀₁ has come to.
enum class ShortEdgeBehind { FromMiddle, FromFirst, CarriedOn };
/// What L₀₂ does behind P₁: it goes on, begins anew with P₁'s own, or stays as it is there.
enum class LongEdgeBehind { GoesOn, FromMiddle, Stands };
/// Between what the span of P₁ and P₂ lies that have the same x: P₁ and what L₀₂ has come to, the
/// two vertices, or what L₀₁ and L₀₂ have come to. Of a right program that is the same.
enum class FlatEnd { ByEdges, FromVertices, FromEdgesBefore };
/// Which vertices are taken for P₀ P₁ P₂: sorted by x, and where that is equal by y, as they were
/// given, or by y from the greatest down; sorted by y; or not sorted. A right program draws the
/// same by any of the first three.
enum class VertexOrder { ByX, ByXThenAsGiven, ByXThenDown, ByY, AsGiven };

/// Some of R G B.
struct ChannelSet {
    std::uint8_t bits = 0; ///< 1 << the channel

    constexpr bool isEmpty() const { return bits == 0; }
    constexpr bool contains(std::size_t channel) const { return (bits >> channel & 1U) != 0; }

    friend constexpr bool operator==(const ChannelSet &, const ChannelSet &) = default;
};
inline constexpr ChannelSet redAlone = {1}, greenAlone = {2}, blueAlone = {4}, allChannels = {7};

/// Departures along an edge: from which end spans are gone through makes a difference.
inline constexpr std::array variantsAlongEdges
    = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne,
       Variant::UnsortedColours};

/// The edge walk of the assignment as a program has it, with what is wrong in it. By default it
/// draws what the column scan and the row walk draw.
struct ProgramWalk {
    std::optional<WalkOrder> order = {}; ///< the method's, if left out
    VertexOrder vertices = VertexOrder::ByX;
    VariantSet departures = {}; ///< beside those of the scene, which along edges are the method's
    VariantSet departuresBehindMiddle
        = {}; ///< those of the edge from the middle vertex to the last alone
    Kept slopes = Kept::All;
    Kept edgeColours = Kept::All; ///< ΔR ΔG ΔB along an edge
    Kept preSteps = Kept::All; ///< ΔR ΔG ΔB along a span, on the way from y_B to ⌈y_B⌉
    Kept steps = Kept::All; ///< the same from sample to sample
    Kept edgePlaces = Kept::All; ///< y along an edge, at each span that it meets
    Kept edgeLevels = Kept::All; ///< R G B along an edge, at each span that it meets
    Kept levels = Kept::All; ///< R G B along a span, at each sample
    PreStep placePreStep = PreStep::ToSample; ///< of an edge's y
    PreStep edgeColourPreStep = PreStep::ToSample; ///< of an edge's R G B
    PreStep spanPreStep = PreStep::ToSample; ///< of R G B along a span
    ChannelSet unsteppedAlongEdges = {};
    ChannelSet unsteppedAlongSpans = {};
    Stepping edgeStepping = Stepping::AfterDrawing;
    Stepping spanStepping = Stepping::AfterDrawing;
    EmptySpan emptySpans = EmptySpan::Steps;
    ShortEdgeBehind shortPlacesBehind = ShortEdgeBehind::FromMiddle;
    ShortEdgeBehind shortColoursBehind = ShortEdgeBehind::FromMiddle;
    LongEdgeBehind longPlacesBehind = LongEdgeBehind::GoesOn;
    LongEdgeBehind longColoursBehind = LongEdgeBehind::GoesOn;
    FlatEnd flatEnd = FlatEnd::ByEdges;
    /// To which span the coordinate of a vertex is taken; but by the rule, an edge has its vertex'
    /// own place and colour there.
    EndRounding spans = EndRounding::ByRule;
    EndRounding first = EndRounding::ByRule;
    EndRounding last = EndRounding::ByRule;
    std::int64_t extraBefore = 0; ///< samples of a span, before its first one
    std::int64_t extraBehind = 0; ///< behind its last one
    SpanDivisor divisor = SpanDivisor::Height;
    LowerColours lowerColours = LowerColours::OfItsEdge;

    /// Whether an edge depends on what was stepped in the spans before, whether they are in the
    /// frame or not.
    bool remembers() const
    {
        return edgePlaces != Kept::All || edgeLevels != Kept::All || !unsteppedAlongEdges.isEmpty()
            || emptySpans != EmptySpan::Steps || shortPlacesBehind != ShortEdgeBehind::FromMiddle
            || shortColoursBehind != ShortEdgeBehind::FromMiddle
            || longPlacesBehind != LongEdgeBehind::GoesOn
            || longColoursBehind != LongEdgeBehind::GoesOn || flatEnd == FlatEnd::FromEdgesBefore
            || vertices == VertexOrder::ByY || vertices == VertexOrder::AsGiven;
    }

    friend bool operator==(const ProgramWalk &, const ProgramWalk &) = default;
};

/// ⌊ ⌋, the nearest or ⌈ ⌉ of a coordinate, px; by the rule ⌈ ⌉.
constexpr std::int64_t wholePixel(Lattice coordinate, EndRounding rounding)
{
    if (rounding == EndRounding::Down)
        return floorPixel(coordinate);
    return rounding == EndRounding::Nearest ? floorPixel(coordinate + halfPixel)
                                            : ceilPixel(coordinate);
}

/// An edge as it is stepped along: with the rates of one from a to b, from a place and a colour.
struct WalkedEdge {
    VariedScan::Edge places, colours;
    Vertex firstPlace = places.a;
    Vertex firstColour = colours.a;
};

/// A walk with all that decides its picture.
struct WalkedProgram {
    const ProgramWalk &walk;
    VariantSet departures; ///< the walk's and the scene's
    ByteRounding rounding = ByteRounding::Nearest;
    EndRounding spans
        = EndRounding::ByRule; ///< the walk's, as seen from the end at which it begins
    WalkSide side = {};

    /// The same behind the middle vertex.
    WalkedProgram behindMiddle() const
    {
        WalkedProgram behind = *this;
        behind.departures.bits |= walk.departuresBehindMiddle.bits;
        return behind;
    }

    WalkedEdge edge(const Vertex &from, const Vertex &to) const
    {
        const VariedScan::Edge edge = VariedScan{departures}.edge(from, to);
        return {shifted(edge, walk.placePreStep), shifted(edge, walk.edgeColourPreStep)};
    }
    PreStep spanPreStep() const
    {
        return departures.contains(Variant::NoColourPreStep) ? PreStep::None : walk.spanPreStep;
    }

private:
    /// To where a vertex is taken to be whose values are had at the edge's first span.
    VariedScan::Edge shifted(VariedScan::Edge edge, PreStep preStep) const
    {
        const Lattice from = edge.a.position.x;
        const Lattice late = wholePixel(from, EndRounding::Up) * unitsPerPixel - from;
        Lattice way = 0;
        if (spans != EndRounding::ByRule)
            way = wholePixel(from, spans) * unitsPerPixel - from;
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
};

/// The samples of a span; those that are drawn lie in the frame.
struct WalkedSpan {
    std::int64_t first = 0, end = 0;
    std::int64_t firstDrawn = 0, endDrawn = 0;
};

/// The two edges of a span, and those whose colours it has at them.
template <class Edge>
struct WalkedBounds {
    const Edge &lower, &upper;
    const Edge &lowerColours, &upperColours;
};

/// Goes through the triangle so, in the scene's arithmetic, or on the triangle's side in float64.
/// Nothing departs in one that has no area or reaches beyond what the arithmetic holds, or in exact
/// arithmetic, or where it remembers the spans before, beyond 2^15 px.
void walkAs(TriangleRuns &triangle, const ProgramWalk &walk);

/// The same, to be done to any triangle.
std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk);

/// The same as a redrawing that can be done together with others.
Redrawing redrawingBy(const ProgramWalk &walk, LevelOverflow overflow);

} // namespace pixelplumb
