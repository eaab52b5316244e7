// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"

namespace pixelplumb {

/// What is kept of a number: all, or what is left of it where it is divided or stored as a whole
/// one, in C (toward 0), by Python's // (down) or by round().
enum class Kept { All, TowardZero, Down, Nearest };
/// How far a first value lies from where it is known: a vertex' first span ⌈x₀⌉ − x₀ from it, a
/// bound's first sample ⌈y_B⌉ − y_B; nothing; x₀ − ⌊x₀⌋; the right way in the wrong direction; or,
/// of a span alone, the right way by which nothing is multiplied: R_B + (⌈y_B⌉ − y_B).
enum class PreStep { ToSample, None, Fraction, Backward, WithoutRate };
/// Which values are kept as whole numbers where such are: from the first on; those that have been
/// stepped: y = int(y + m), from a y that is none; or, of a span's colours, the first alone.
enum class Storing { FromFirst, BehindSteps, FirstAlone };
/// When what is stepped is stepped.
enum class Stepping { AfterDrawing, BeforeDrawing };
/// What happens to the edges at a span without samples.
enum class EmptySpan { Steps, Waits };
/// To which sample a bound of a span is taken: what the fill rule says, ⌊ ⌋, the nearest, ⌈ ⌉; or
/// as the rule says but for a sample on the bound itself, which is owned where it is not by the
/// rule.
enum class EndRounding { ByRule, Down, Nearest, Up, OnBoundOtherwise };
/// By what a span's difference of colours is divided: y_T − y_B; this and one; this less one, which
/// may be negative; this where it is at least one, else 0; ⌊y_T⌋ − ⌊y_B⌋; the number of its
/// samples; or the steps from its first sample to its last. By 0 nothing is, and nothing stepped.
enum class SpanDivisor {
    Height,
    HeightAndOne,
    HeightLessOne,
    HeightFromOne,
    HeightOfFloors,
    Samples,
    Steps
};
/// Whose colours are taken for the lower bound's: its own edge's, or always those of the short
/// edge, of the long one or of the upper bound, the other bound having the other's.
enum class LowerColours { OfItsEdge, OfShortEdge, OfLongEdge, OfUpperEdge };
/// How the colours go along a span: from y_B up by ΔR; from y_T up; down from y_B by as much; from
/// the last sample, which has what is the first one's; or not at all, the lower bound's, the upper
/// one's or the mean of both being that of all samples.
enum class SpanColours {
    FromLowerBound,
    FromUpperBound,
    Falling,
    FromLastSample,
    LowerAlone,
    UpperAlone,
    Mean
};
/// Whether all samples have one.
constexpr bool isFlat(SpanColours colours) { return colours >= SpanColours::LowerAlone; }
/// With what the colours of a span begin: with those of its bound; or, but for the first span of a
/// triangle or of each of its halves, with what the span before has come to behind its last sample.
enum class SpanStart { AtBound, GoesOn, GoesOnInHalf };
/// Which edge of a span is its upper bound: the one that is; or L₀₂ always, never, where
/// y₁ < y₀, where y₁ < y₂, or where m₀₁ ≤ m₀₂, a slope along the spans being 0.
enum class UpperEdge { TheUpper, Long, Short, LongIfBelowFirst, LongIfBelowLast, LongBySlopes };
/// What a slope is: Δy/Δx, Δx/Δy, −Δy/Δx, or |Δy|/Δx.
enum class SlopeForm { RiseOverRun, RunOverRise, Negated, OfMagnitude };
/// By what the colours of an edge are divided: Δx, Δy or |Δy|.
enum class EdgeColourDivisor { Run, Rise, RiseMagnitude };
/// What is added to a colour of an edge: its step, or the opposite.
enum class EdgeColourSign { Right, Negated };
/// With what L₁₂ begins: with P₁'s own, with P₀'s, or with what L₀₁ has come to.
enum class ShortEdgeBehind { FromMiddle, FromFirst, CarriedOn };
/// Which edge a rate is of: the edge itself, L₀₁ or L₀₂; or that its rise is L₀₁'s or L₀₂'s, or its
/// run.
enum class RateOf { Own, FirstEdge, LongEdge, FirstRise, LongRise, FirstRun, LongRun };
/// What L₀₂ does behind P₁: it goes on, stays as it is there, or begins anew: with P₁'s own, with
/// P₀'s, or with what is its own at P₁, taken for that of the first span behind.
enum class LongEdgeBehind { GoesOn, Stands, FromMiddle, FromFirst, WithoutPreStep };
constexpr bool isBegunAnew(LongEdgeBehind behind) { return behind >= LongEdgeBehind::FromMiddle; }
/// What L₀₂ does before P₁: it is stepped, or waits.
enum class LongEdgeBefore { Steps, Waits };
/// To which half the span belongs on which P₁ lies: the second one; to both, for each of which L₀₂
/// is stepped. Or, where P₁ lies between two, the second half begins at the one before it, or at
/// the nearest.
enum class MiddleSpan { InSecondHalf, InBothHalves, FromSpanBefore, FromNearest };
/// To which span a triangle goes at one of its ends: what the fill rule says; one that its vertex
/// does not reach, unless it lies on it; the nearest; or one more than the rule says.
enum class SpanEnd { ByRule, Outward, Nearest, OneMore };
/// Between what the span of P₁ and P₂ lies that have the same x: P₁ and what L₀₂ has come to, the
/// two vertices, or what L₀₁ and L₀₂ have come to. Of a right program that is the same.
enum class FlatEnd { ByEdges, FromVertices, FromEdgesBefore };
/// Which vertices are taken for P₀ P₁ P₂: sorted by x, and where that is equal by y, as they were
/// given, or by y from the greatest down; sorted by y; not sorted; or by x with these comparisons
/// alone, the one after the other: 01 12 is the first vertex with the second, the second with the
/// third. A right program draws the same by any of the first three.
enum class VertexOrder {
    ByX,
    ByXThenAsGiven,
    ByXThenDown,
    ByY,
    AsGiven,
    Compared01,
    Compared12,
    Compared02,
    Compared01And12,
    Compared12And01,
    Compared01And02,
    Compared02And12
};
/// Whether each of three vertices has its place then.
constexpr bool isSortedByX(VertexOrder order) { return order <= VertexOrder::ByXThenDown; }

/// Edges of a triangle: all, or L₀₁, L₁₂ or L₀₂ alone.
enum class WalkedEdges { All, First, Second, Long };
/// Whose slope each of L₀₁ L₁₂ L₀₂ has; that of one along the spans is 0.
using SlopeSources = std::array<WalkedEdges, 3>;
inline constexpr SlopeSources ownSlopes
    = {WalkedEdges::First, WalkedEdges::Second, WalkedEdges::Long};
/// What is divided by an edge's Δx: its rise and the differences of its colours, or one of these.
enum class EdgeRates { All, Slope, Colours };

/// Some of R G B.
struct ChannelSet {
    std::uint8_t bits = 0; ///< 1 << the channel

    constexpr bool isEmpty() const { return bits == 0; }
    constexpr bool contains(std::size_t channel) const { return (bits >> channel & 1U) != 0; }

    friend constexpr bool operator==(const ChannelSet &, const ChannelSet &) = default;
};
inline constexpr ChannelSet redAlone = {1}, greenAlone = {2}, blueAlone = {4}, allChannels = {7},
                            greenAndBlue = {6};
/// Which channel each of R G B takes something of.
using ChannelSources = std::array<std::uint8_t, 3>;
inline constexpr ChannelSources ownChannels = {0, 1, 2};

/// Departures along an edge: from which end spans are gone through makes a difference.
inline constexpr std::array variantsAlongEdges
    = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne,
       Variant::UnsortedColours};

/// The edge walk of the assignment as a program has it, with what is wrong in it. By default it
/// draws what the column scan and the row walk draw.
struct ProgramWalk {
    std::optional<SpanOrder> order = {}; ///< the method's, if left out
    VertexOrder vertices = VertexOrder::ByX;
    VariantSet departures = {}; ///< beside those of the scene, which along edges are the method's
    EdgeRates divided = EdgeRates::All; ///< of which another divisor is one
    WalkedEdges departing = WalkedEdges::All; ///< in all that is an edge's own
    SlopeForm slopeForm = SlopeForm::RiseOverRun;
    Kept slopes = Kept::All;
    Kept edgeColours = Kept::All; ///< ΔR ΔG ΔB along an edge
    Kept preSteps = Kept::All; ///< ΔR ΔG ΔB along a span, on the way from y_B to ⌈y_B⌉
    Kept steps = Kept::All; ///< the same from sample to sample
    Kept runEnds = Kept::All; ///< x of an edge's ends, of which Δx is taken
    Kept edgePlaces = Kept::All; ///< y along an edge, at each span that it meets
    Kept edgeLevels = Kept::All; ///< R G B along an edge, at each span that it meets
    Kept bounds = Kept::All; ///< R_B and R_T, where a span takes them from its edges
    Kept levels = Kept::All; ///< R G B along a span, at each sample
    PreStep placePreStep = PreStep::ToSample; ///< of an edge's y
    PreStep edgeColourPreStep = PreStep::ToSample; ///< of an edge's R G B
    PreStep spanPreStep = PreStep::ToSample; ///< of R G B along a span
    Storing edgeStoring = Storing::FromFirst;
    Storing spanStoring = Storing::FromFirst;
    ChannelSet withoutEdgePreStep = {};
    ChannelSet withoutSpanPreStep = {};
    ChannelSet unsteppedAlongEdges = {};
    ChannelSet unsteppedAlongSpans = {};
    ChannelSources ratesAlongEdgesOf = ownChannels; ///< in the pre-step, too
    ChannelSources stepsAlongEdgesOf = ownChannels;
    ChannelSources ratesAlongSpansOf = ownChannels; ///< in the pre-step, too
    ChannelSources stepsAlongSpansOf = ownChannels;
    EdgeColourDivisor edgeColourDivisor = EdgeColourDivisor::Run;
    EdgeColourSign edgeColourSign = EdgeColourSign::Right;
    Stepping placeStepping = Stepping::AfterDrawing;
    Stepping edgeColourStepping = Stepping::AfterDrawing;
    Stepping spanStepping = Stepping::AfterDrawing;
    EmptySpan emptySpans = EmptySpan::Steps;
    ShortEdgeBehind shortPlacesBehind = ShortEdgeBehind::FromMiddle;
    ShortEdgeBehind shortColoursBehind = ShortEdgeBehind::FromMiddle;
    RateOf firstSlope = RateOf::Own;
    RateOf firstColourRates = RateOf::Own;
    RateOf secondSlope = RateOf::Own;
    RateOf secondColourRates = RateOf::Own;
    RateOf longSlope = RateOf::Own;
    RateOf longColourRates = RateOf::Own;
    SlopeSources slopesOf = ownSlopes; ///< where they are exchanged
    LongEdgeBefore longPlacesBefore = LongEdgeBefore::Steps;
    LongEdgeBefore longColoursBefore = LongEdgeBefore::Steps;
    LongEdgeBehind longPlacesBehind = LongEdgeBehind::GoesOn;
    LongEdgeBehind longColoursBehind = LongEdgeBehind::GoesOn;
    FlatEnd flatEnd = FlatEnd::ByEdges;
    MiddleSpan middleSpan = MiddleSpan::InSecondHalf;
    UpperEdge upperEdge = UpperEdge::TheUpper;
    /// To which span the coordinate of a vertex is taken; but by the rule, an edge has its vertex'
    /// own place and colour there.
    EndRounding spans = EndRounding::ByRule;
    SpanEnd leastSpan = SpanEnd::ByRule; ///< of the vertex with the least coordinate
    SpanEnd greatestSpan = SpanEnd::ByRule;
    EndRounding first = EndRounding::ByRule;
    EndRounding last = EndRounding::ByRule;
    std::int64_t extraBefore = 0; ///< samples of a span, before its first one
    std::int64_t extraBehind = 0; ///< behind its last one
    SpanDivisor divisor = SpanDivisor::Height;
    LowerColours lowerColours = LowerColours::OfItsEdge;
    SpanColours spanColours = SpanColours::FromLowerBound;
    SpanStart spanStart = SpanStart::AtBound;

    /// Whether an edge depends on what was stepped in the spans before, whether they are in the
    /// frame or not.
    bool remembers() const
    {
        return edgePlaces != Kept::All || edgeLevels != Kept::All || !unsteppedAlongEdges.isEmpty()
            || stepsAlongEdgesOf != ownChannels || spanStart != SpanStart::AtBound
            || emptySpans != EmptySpan::Steps || shortPlacesBehind != ShortEdgeBehind::FromMiddle
            || shortColoursBehind != ShortEdgeBehind::FromMiddle
            || longPlacesBehind != LongEdgeBehind::GoesOn
            || longColoursBehind != LongEdgeBehind::GoesOn
            || longPlacesBefore != LongEdgeBefore::Steps
            || longColoursBefore != LongEdgeBefore::Steps || flatEnd == FlatEnd::FromEdgesBefore
            || middleSpan != MiddleSpan::InSecondHalf || !isSortedByX(vertices);
    }

    /// The same but for what is an edge's own.
    ProgramWalk withRightEdges() const;

    friend bool operator==(const ProgramWalk &, const ProgramWalk &) = default;
};

/// Goes through the triangle so, in the scene's arithmetic, or on the triangle's side in float64.
/// False, and nothing is changed, of one that has no area or reaches beyond what the arithmetic
/// holds, or in exact arithmetic, or where it remembers the spans before, beyond 2^15 px.
bool walkAs(TriangleRuns &triangle, const ProgramWalk &walk);

/// The same, to be done to any triangle.
std::function<void(TriangleRuns &triangle)> walking(const ProgramWalk &walk);

/// The same as a redrawing that can be done together with others.
Redrawing redrawingBy(const ProgramWalk &walk, LevelOverflow overflow);

} // namespace pixelplumb
