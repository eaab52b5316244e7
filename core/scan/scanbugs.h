// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// The mistakes of a program that walks along a triangle's edges, as settings of the mistaken scan
/// (mistakes/mistakenscan.h).
namespace pixelplumb {

/// In which order a triangle's spans are visited: as the method does, or from one end.
enum class WalkOrder : std::uint8_t { OfMethod, Ascending, Descending };
/// What is kept of a number: all, or what remains when it is divided or stored as a whole number,
/// in C (toward 0), by Python's // (down) or by round().
enum class Truncation : std::uint8_t { All, TowardZero, Down, Nearest };
/// The distance from where a first value is known to where it is needed: ⌈x₀⌉ − x₀ from a vertex to
/// its first span, ⌈y_B⌉ − y_B from a bound to its first sample; nothing; x₀ − ⌊x₀⌋; the right
/// distance in the wrong direction; or, in spans only, the right distance without its factor: R_B +
/// (⌈y_B⌉ − y_B).
enum class PreStep : std::uint8_t { ToSample, None, Fraction, Backward, WithoutRate };
/// Which values become whole numbers where they are kept as such: all from the first on; only
/// stepped ones, y = int(y + m) from a fractional y; only the first, in a span's colours; or what
/// is added to the value of the edge's vertex, or of the span's bound, y₀ + Δy·(x − x₀)/Δx, with
/// the product in all bits or, along edges, in 16.
enum class Storing : std::uint8_t { FromFirst, BehindSteps, FirstAlone, Added, AddedOfShorts };
constexpr bool isOfAdded(Storing storing) { return storing >= Storing::Added; }
/// When values are stepped.
enum class Stepping : std::uint8_t { AfterDrawing, BeforeDrawing };
/// What happens to the edges at a span without samples.
enum class EmptySpan : std::uint8_t { Steps, Waits };
/// How a bound of a span is rounded to a sample: by the fill rule, ⌊ ⌋, to nearest, ⌈ ⌉; by the
/// rule with the opposite ownership of a sample on the bound itself; or it is sample 0, if first.
enum class EndRounding : std::uint8_t { ByRule, Down, Nearest, Up, OnBoundOtherwise, AtZero };
/// The divisor of a span's difference of colours: y_T − y_B; this plus one; this minus one, which
/// may be negative; this if at least one, else 0; ⌊y_T⌋ − ⌊y_B⌋; the number of its samples; or of
/// steps from its first sample to its last. A divisor of 0 means no division and no steps.
enum class SpanDivisor : std::uint8_t {
    Height,
    HeightAndOne,
    HeightLessOne,
    HeightFromOne,
    HeightOfFloors,
    Samples,
    Steps
};
/// Whose colours the lower bound has: its own edge's, or always those of the short edge, the long
/// edge or the upper bound; the other bound has the other's.
enum class LowerColours : std::uint8_t { OfItsEdge, OfShortEdge, OfLongEdge, OfUpperEdge };
/// How colours run along a span: from y_B up by ΔR; from y_T up; down from y_B by the same amount;
/// from the last sample, which has the first one's colour; or constant, as the lower bound's, the
/// upper bound's or their mean.
enum class SpanColours : std::uint8_t {
    FromLowerBound,
    FromUpperBound,
    Falling,
    FromLastSample,
    LowerAlone,
    UpperAlone,
    Mean
};
/// Whether all samples have one colour.
constexpr bool isFlat(SpanColours colours) { return colours >= SpanColours::LowerAlone; }
/// Where a span's colours begin: at its bound; or, except in the first span of the triangle or of
/// each half, with the values just after the last sample of the span before.
enum class SpanStart : std::uint8_t { AtBound, GoesOn, GoesOnInHalf };
/// Which edge of a span is its upper bound: the actual one; or L₀₂ always, never, where y₁ < y₀,
/// where y₁ < y₂, or where m₀₁ ≤ m₀₂, with slope 0 along the spans.
enum class UpperEdge : std::uint8_t {
    TheUpper,
    Long,
    Short,
    LongIfBelowFirst,
    LongIfBelowLast,
    LongBySlopes
};
/// How a slope is computed: Δy/Δx, Δx/Δy, −Δy/Δx, or |Δy|/Δx.
enum class SlopeForm : std::uint8_t { RiseOverRun, RunOverRise, Negated, OfMagnitude };
/// The divisor of an edge's differences of colour: Δx, Δy or |Δy|.
enum class EdgeColourDivisor : std::uint8_t { Run, Rise, RiseMagnitude };
/// What is added to an edge's colour: its step, or the opposite.
enum class EdgeColourSign : std::uint8_t { Right, Negated };
/// Where L₁₂ begins: with P₁'s own values, with P₀'s, or with those that L₀₁ has reached.
enum class ShortEdgeBehind : std::uint8_t { FromMiddle, FromFirst, CarriedOn };
/// Which edge a rate is computed from: the edge itself, L₀₁ or L₀₂; or only its rise or only its
/// run is that of L₀₁ or L₀₂.
enum class RateOf : std::uint8_t {
    Own,
    FirstEdge,
    LongEdge,
    FirstRise,
    LongRise,
    FirstRun,
    LongRun
};
/// What L₀₂ does after P₁: it goes on, keeps its value, or begins anew: with P₁'s own values, with
/// P₀'s, or with its own value at P₁, used for the first span after it.
enum class LongEdgeBehind : std::uint8_t { GoesOn, Stands, FromMiddle, FromFirst, WithoutPreStep };
constexpr bool isBegunAnew(LongEdgeBehind behind) { return behind >= LongEdgeBehind::FromMiddle; }
/// What L₀₂ does before P₁: it is stepped, or waits.
enum class LongEdgeBefore : std::uint8_t { Steps, Waits };
/// Which half has the span that P₁ lies on: the second; or both, with L₀₂ stepped for each. Or,
/// where P₁ lies between two spans, the second half begins at the one before it, or at the nearest.
enum class MiddleSpan : std::uint8_t { InSecondHalf, InBothHalves, FromSpanBefore, FromNearest };
/// Where a triangle's spans begin or end: by the fill rule; at a span beyond the vertex, unless the
/// vertex lies on one; at the nearest; one span beyond the rule's; or at span 0, if least.
enum class SpanEnd : std::uint8_t { ByRule, Outward, Nearest, OneMore, AtZero };
/// The ends of the span on which P₁ and P₂ lie if they have the same x: P₁ and the value L₀₂ has
/// reached; the two vertices; or the values L₀₁ and L₀₂ have reached. In a right program all agree.
enum class FlatEnd : std::uint8_t { ByEdges, FromVertices, FromEdgesBefore };
/// Which vertices serve as P₀ P₁ P₂: sorted by x, with ties sorted by y, kept as given, or sorted
/// by y descending; sorted by y; not sorted; or by x with only these comparisons in sequence: 01 12
/// compares the first vertex with the second, then the second with the third. A right program draws
/// the same with any of the first three.
enum class VertexOrder : std::uint8_t {
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

/// Edges of a triangle: all, or only L₀₁, L₁₂ or L₀₂.
enum class WalkedEdges : std::uint8_t { All, First, Second, Long };
/// Whose slopes the edges have: their own, or two of them have each other's, L₀₁ and L₁₂, L₀₁ and
/// L₀₂ or L₁₂ and L₀₂; an edge along the spans has slope 0.
enum class SlopeExchange : std::uint8_t { None, OfShort, OfFirstAndLong, OfSecondAndLong };
/// What is divided by an edge's Δx: its rise and its differences of colour, or only one of these.
enum class EdgeRates : std::uint8_t { All, Slope, Colours };
/// Which vertex has which colour: its own, or sorted vertices have those of the order given.
enum class VertexColours : std::uint8_t { Own, AsGiven };
/// How a level outside 0 … 255 is treated.
enum class LevelOverflow : std::uint8_t { Clamps, Wraps };

/// A subset of R G B.
struct ChannelSet {
    std::uint8_t bits = 0; ///< 1 << the channel

    constexpr bool isEmpty() const { return bits == 0; }
    constexpr bool contains(std::size_t channel) const { return (bits >> channel & 1U) != 0; }

    friend constexpr bool operator==(const ChannelSet &, const ChannelSet &) = default;
};
inline constexpr ChannelSet redAlone = {1}, greenAlone = {2}, blueAlone = {4}, allChannels = {7},
                            greenAndBlue = {6};

/// Which channel each of R G B takes something from: its own, or some take another's.
enum class ChannelSource : std::uint8_t { Own, GreenOfRed, BlueOfRed, BlueOfGreen, AllOfRed };
constexpr std::size_t sourceOf(std::size_t channel, ChannelSource source)
{
    constexpr std::array<std::array<std::uint8_t, 3>, 5> sources
        = {{{0, 1, 2}, {0, 0, 2}, {0, 1, 0}, {0, 1, 1}, {0, 0, 0}}};
    return sources[std::size_t(source)][channel];
}

/// The changes of an edge's run and pre-step that are variants of the scan, too; they add up.
struct EdgeChanges {
    std::uint8_t bits = 0;

    constexpr bool contains(EdgeChanges changes) const
    {
        return (bits & changes.bits) == changes.bits;
    }
    friend constexpr EdgeChanges operator|(EdgeChanges a, EdgeChanges b)
    {
        return {std::uint8_t(a.bits | b.bits)};
    }
    friend constexpr bool operator==(EdgeChanges, EdgeChanges) = default;
};
namespace edgechange {
inline constexpr EdgeChanges noPreStep = {1}, divisorMinusOne = {2}, divisorPlusOne = {4};
} // namespace edgechange

/// What a program that walks along edges does wrong. Each setting is one byte, 0 where it is right,
/// and a row of scanSettings().
struct ScanBugs {
    WalkOrder order = WalkOrder::OfMethod; ///< no mistake by itself
    VertexOrder vertices = VertexOrder::ByX;
    VertexColours vertexColours = VertexColours::Own;
    EdgeChanges edgeChanges = {};
    EdgeRates divided = EdgeRates::All; ///< the rates that a wrong divisor applies to
    WalkedEdges departing = WalkedEdges::All; ///< the edges on which an edge's own mistakes occur
    SlopeForm slopeForm = SlopeForm::RiseOverRun;
    Truncation slopes = Truncation::All;
    Truncation edgeColours = Truncation::All; ///< ΔR ΔG ΔB along an edge
    Truncation preSteps = Truncation::All; ///< ΔR ΔG ΔB along a span, on the way from y_B to ⌈y_B⌉
    Truncation steps = Truncation::All; ///< ΔR ΔG ΔB from sample to sample
    Truncation runEnds = Truncation::All; ///< x of an edge's ends, from which Δx is computed
    Truncation edgePlaces = Truncation::All; ///< y along an edge, at each span
    Truncation edgeLevels = Truncation::All; ///< R G B along an edge, at each span
    Truncation bounds = Truncation::All; ///< R_B and R_T, where a span takes them from its edges
    Truncation levels = Truncation::All; ///< R G B along a span, at each sample
    PreStep placePreStep = PreStep::ToSample; ///< of an edge's y
    PreStep edgeColourPreStep = PreStep::ToSample; ///< of an edge's R G B
    PreStep spanPreStep = PreStep::ToSample; ///< of R G B along a span
    Storing edgeStoring = Storing::FromFirst;
    Storing spanStoring = Storing::FromFirst;
    ChannelSet withoutEdgePreStep = {};
    ChannelSet withoutSpanPreStep = {};
    ChannelSet unsteppedAlongEdges = {};
    ChannelSet unsteppedAlongSpans = {};
    ChannelSource ratesAlongEdgesOf = ChannelSource::Own; ///< also in the pre-step
    ChannelSource stepsAlongEdgesOf = ChannelSource::Own;
    ChannelSource ratesAlongSpansOf = ChannelSource::Own; ///< also in the pre-step
    ChannelSource stepsAlongSpansOf = ChannelSource::Own;
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
    SlopeExchange slopesOf = SlopeExchange::None;
    LongEdgeBefore longPlacesBefore = LongEdgeBefore::Steps;
    LongEdgeBefore longColoursBefore = LongEdgeBefore::Steps;
    LongEdgeBehind longPlacesBehind = LongEdgeBehind::GoesOn;
    LongEdgeBehind longColoursBehind = LongEdgeBehind::GoesOn;
    FlatEnd flatEnd = FlatEnd::ByEdges;
    MiddleSpan middleSpan = MiddleSpan::InSecondHalf;
    UpperEdge upperEdge = UpperEdge::TheUpper;
    /// How a vertex's coordinate is rounded to a span; unless by the rule, the edge has the
    /// vertex's own position and colour at that span.
    EndRounding spans = EndRounding::ByRule;
    SpanEnd leastSpan = SpanEnd::ByRule; ///< at the vertex with the least coordinate
    SpanEnd greatestSpan = SpanEnd::ByRule;
    EndRounding first = EndRounding::ByRule;
    EndRounding last = EndRounding::ByRule;
    std::int8_t extraBefore = 0; ///< samples before a span's first one
    std::int8_t extraBehind = 0; ///< samples after its last one
    SpanDivisor divisor = SpanDivisor::Height;
    LowerColours lowerColours = LowerColours::OfItsEdge;
    SpanColours spanColours = SpanColours::FromLowerBound;
    SpanStart spanStart = SpanStart::AtBound;
    LevelOverflow overflow = LevelOverflow::Clamps;

    bool isRight() const { return *this == ScanBugs(); }
    /// Whether an edge depends on steps in earlier spans, inside the frame or not.
    bool remembers() const;
    /// Whether it makes a difference from which end the spans are visited.
    bool hasOrder() const;
    /// The same bugs without those that are an edge's own.
    ScanBugs withRightEdges() const;

    friend bool operator==(const ScanBugs &, const ScanBugs &) = default;
};

/// What a setting is about: each edge by itself, the three edges and which one goes where, the
/// first and last span or sample, a span between its two bounds, or its samples.
enum class SettingPart : std::uint8_t { Edge, Edges, End, Span, Sample };

/// A setting of the mistaken scan.
struct ScanSetting {
    static constexpr std::uint8_t never = 255;

    std::string_view id; ///< "slopes"
    std::size_t place; ///< of its byte in ScanBugs
    SettingPart part;
    std::uint8_t ordersFrom = never; ///< from this value on the order of spans makes a difference
    std::uint8_t remembersFrom = never; ///< from this value on the spans before make a difference
    bool isSet = false; ///< its bits are added when two bugs are merged
};

/// All settings, a row each.
std::span<const ScanSetting> scanSettings();
std::uint8_t valueOf(const ScanSetting &setting, const ScanBugs &bugs);
void setValue(const ScanSetting &setting, std::uint8_t value, ScanBugs &bugs);

/// The bugs of a program that has both; none where they change the same decision.
std::optional<ScanBugs> together(const ScanBugs &one, const ScanBugs &other);

} // namespace pixelplumb
