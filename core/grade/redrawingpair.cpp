// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/defect.h"
#include "core/grade/programedgetest.h"
#include "core/grade/programwalk.h"

namespace pixelplumb {

namespace {

/// Merges two walks member by member: only one of them may differ from the right walk in a member.
class WalkMerger {
public:
    WalkMerger(const ProgramWalk &one, const ProgramWalk &other)
        : m_one(one)
        , m_other(other)
    {
        // All members by name: a new one does not compile until it is listed here.
        const auto &[order, vertices, departures, divided, departing, slopeForm, slopes,
                     edgeColours, preSteps, steps, runEnds, edgePlaces, edgeLevels, bounds, levels,
                     placePreStep, edgeColourPreStep, spanPreStep, edgeStoring, spanStoring,
                     withoutEdgePreStep, withoutSpanPreStep, unsteppedAlongEdges,
                     unsteppedAlongSpans, ratesAlongEdgesOf, stepsAlongEdgesOf, ratesAlongSpansOf,
                     stepsAlongSpansOf, edgeColourDivisor, edgeColourSign, placeStepping,
                     edgeColourStepping, spanStepping, emptySpans, shortPlaces, shortColours,
                     firstSlope, firstColourRates, secondSlope, secondColourRates, longSlope,
                     longColourRates, slopesOf, longPlacesBefore, longColoursBefore, longPlaces,
                     longColours, flatEnd, middleSpan, upperEdge, spans, leastSpan, greatestSpan,
                     first, last, extraBefore, extraBehind, divisor, lowerColours, spanColours,
                     spanStart]
            = m_right;
        // Merged, a departure on one edge would spread to the other walk's edges.
        m_isContradiction = one.departing != other.departing && departsAlongEdges(one)
            && departsAlongEdges(other);
        if (one.edgeStoring != other.edgeStoring && storesAlongEdges(one)
            && storesAlongEdges(other))
            m_isContradiction = true;
        m_both.order = one.order ? one.order : other.order ? other.order : order;
        takeDepartures(&ProgramWalk::departures, departures);
        takeChannels(&ProgramWalk::withoutEdgePreStep, withoutEdgePreStep);
        takeChannels(&ProgramWalk::withoutSpanPreStep, withoutSpanPreStep);
        takeChannels(&ProgramWalk::unsteppedAlongEdges, unsteppedAlongEdges);
        takeChannels(&ProgramWalk::unsteppedAlongSpans, unsteppedAlongSpans);
        take(&ProgramWalk::vertices, vertices);
        take(&ProgramWalk::divided, divided);
        take(&ProgramWalk::departing, departing);
        take(&ProgramWalk::slopeForm, slopeForm);
        take(&ProgramWalk::slopes, slopes);
        take(&ProgramWalk::edgeColours, edgeColours);
        take(&ProgramWalk::preSteps, preSteps);
        take(&ProgramWalk::steps, steps);
        take(&ProgramWalk::runEnds, runEnds);
        take(&ProgramWalk::edgePlaces, edgePlaces);
        take(&ProgramWalk::edgeLevels, edgeLevels);
        take(&ProgramWalk::bounds, bounds);
        take(&ProgramWalk::levels, levels);
        take(&ProgramWalk::placePreStep, placePreStep);
        take(&ProgramWalk::edgeColourPreStep, edgeColourPreStep);
        take(&ProgramWalk::spanPreStep, spanPreStep);
        take(&ProgramWalk::edgeStoring, edgeStoring);
        take(&ProgramWalk::spanStoring, spanStoring);
        take(&ProgramWalk::ratesAlongEdgesOf, ratesAlongEdgesOf);
        take(&ProgramWalk::stepsAlongEdgesOf, stepsAlongEdgesOf);
        take(&ProgramWalk::ratesAlongSpansOf, ratesAlongSpansOf);
        take(&ProgramWalk::stepsAlongSpansOf, stepsAlongSpansOf);
        take(&ProgramWalk::edgeColourDivisor, edgeColourDivisor);
        take(&ProgramWalk::edgeColourSign, edgeColourSign);
        take(&ProgramWalk::placeStepping, placeStepping);
        take(&ProgramWalk::edgeColourStepping, edgeColourStepping);
        take(&ProgramWalk::spanStepping, spanStepping);
        take(&ProgramWalk::emptySpans, emptySpans);
        take(&ProgramWalk::shortPlacesBehind, shortPlaces);
        take(&ProgramWalk::shortColoursBehind, shortColours);
        take(&ProgramWalk::firstSlope, firstSlope);
        take(&ProgramWalk::firstColourRates, firstColourRates);
        take(&ProgramWalk::secondSlope, secondSlope);
        take(&ProgramWalk::secondColourRates, secondColourRates);
        take(&ProgramWalk::longSlope, longSlope);
        take(&ProgramWalk::longColourRates, longColourRates);
        take(&ProgramWalk::slopesOf, slopesOf);
        take(&ProgramWalk::longPlacesBefore, longPlacesBefore);
        take(&ProgramWalk::longColoursBefore, longColoursBefore);
        take(&ProgramWalk::longPlacesBehind, longPlaces);
        take(&ProgramWalk::longColoursBehind, longColours);
        take(&ProgramWalk::flatEnd, flatEnd);
        take(&ProgramWalk::middleSpan, middleSpan);
        take(&ProgramWalk::upperEdge, upperEdge);
        take(&ProgramWalk::spans, spans);
        take(&ProgramWalk::leastSpan, leastSpan);
        take(&ProgramWalk::greatestSpan, greatestSpan);
        take(&ProgramWalk::first, first);
        take(&ProgramWalk::last, last);
        take(&ProgramWalk::extraBefore, extraBefore);
        take(&ProgramWalk::extraBehind, extraBehind);
        take(&ProgramWalk::divisor, divisor);
        take(&ProgramWalk::lowerColours, lowerColours);
        take(&ProgramWalk::spanColours, spanColours);
        take(&ProgramWalk::spanStart, spanStart);
    }

    std::optional<ProgramWalk> both() const
    {
        return m_isContradiction ? std::nullopt : std::optional(m_both);
    }

private:
    static bool departsAlongEdges(const ProgramWalk &walk) { return walk.withRightEdges() != walk; }

    static bool storesAlongEdges(const ProgramWalk &walk)
    {
        return walk.edgePlaces != Truncation::All || walk.edgeLevels != Truncation::All;
    }

    template <class Member>
    void take(Member ProgramWalk::*member, const Member &right)
    {
        const bool isDone = m_one.*member != right;
        if (isDone && m_other.*member != right)
            m_isContradiction = true;
        m_both.*member = isDone ? m_one.*member : m_other.*member;
    }

    /// Departures add up, except for the same one in both and those that undo each other.
    void takeDepartures(VariantSet ProgramWalk::*member, const VariantSet &right)
    {
        const VariantSet one = m_one.*member;
        const VariantSet other = m_other.*member;
        VariantSet both = right;
        both.bits |= one.bits | other.bits;
        if ((one.bits & other.bits) != 0 || undoEachOther(both))
            m_isContradiction = true;
        m_both.*member = both;
    }

    void takeChannels(ChannelSet ProgramWalk::*member, const ChannelSet &right)
    {
        const ChannelSet one = m_one.*member;
        const ChannelSet other = m_other.*member;
        if ((one.bits & other.bits) != 0)
            m_isContradiction = true;
        m_both.*member = {std::uint8_t(right.bits | one.bits | other.bits)};
    }

    const ProgramWalk m_right;
    const ProgramWalk &m_one, &m_other;
    ProgramWalk m_both;
    bool m_isContradiction = false;
};

/// Whether the order of its spans matters.
bool hasOrder(ProgramWalk walk)
{
    const ProgramWalk right;
    // Mistakes within a span do not depend on it.
    walk.preSteps = right.preSteps;
    walk.steps = right.steps;
    walk.bounds = right.bounds;
    walk.levels = right.levels;
    walk.spanPreStep = right.spanPreStep;
    walk.spanStoring = right.spanStoring;
    walk.withoutSpanPreStep = right.withoutSpanPreStep;
    walk.unsteppedAlongSpans = right.unsteppedAlongSpans;
    walk.ratesAlongSpansOf = right.ratesAlongSpansOf;
    walk.stepsAlongSpansOf = right.stepsAlongSpansOf;
    walk.spanStepping = right.spanStepping;
    walk.first = right.first;
    walk.last = right.last;
    walk.extraBefore = right.extraBefore;
    walk.extraBehind = right.extraBehind;
    walk.divisor = right.divisor;
    walk.lowerColours = right.lowerColours;
    walk.spanColours = right.spanColours;
    if (walk.upperEdge != UpperEdge::LongBySlopes) // an edge along the spans comes first
        walk.upperEdge = right.upperEdge;
    // Ends identified by their coordinate do not depend on it.
    for (SpanEnd *end : {&walk.leastSpan, &walk.greatestSpan}) {
        if (*end != SpanEnd::OneMore)
            *end = SpanEnd::ByRule;
    }
    // No mistakes from either end.
    walk.flatEnd = right.flatEnd;
    if (walk.vertices == VertexOrder::ByXThenAsGiven || walk.vertices == VertexOrder::ByXThenDown)
        walk.vertices = right.vertices;
    return walk != right;
}

std::optional<ProgramWalk> merged(const ProgramWalk &one, const ProgramWalk &other)
{
    const bool areOpposed = hasOrder(one) && hasOrder(other) && one.order != other.order;
    return areOpposed ? std::nullopt : WalkMerger(one, other).both();
}

} // namespace

Redrawing redrawingBy(const ProgramWalk &walk, LevelOverflow overflow)
{
    return {
        walking(walk), overflow, Repainting::Over, {}, std::make_shared<const ProgramWalk>(walk)};
}

std::optional<Redrawing> together(const Redrawing &one, const Redrawing &other)
{
    const auto findsSamples
        = [](const Redrawing &each) { return each.walk != nullptr || each.edgeTest != nullptr; };
    if (findsSamples(other) && !findsSamples(one))
        return together(other, one);
    // A program finds its samples in one way; only two walks can be merged.
    const bool areTwoWays = findsSamples(one) && findsSamples(other) && !(one.walk && other.walk);
    if (areTwoWays)
        return std::nullopt;
    const bool isWrapping
        = one.overflow == LevelOverflow::Wraps || other.overflow == LevelOverflow::Wraps;
    const auto overflow = isWrapping ? LevelOverflow::Wraps : LevelOverflow::Clamps;
    // A walk rounds its own levels, as does a program with other weights of colours.
    const bool roundsItself = one.walk || (one.edgeTest && one.edgeTest->changesColours());
    const bool areTwoRoundings = (roundsItself || !one.bytes.isRight()) && !other.bytes.isRight();
    if (areTwoRoundings)
        return std::nullopt;
    Redrawing both;
    if (one.walk && other.walk) {
        const auto walk = merged(*one.walk, *other.walk);
        if (!walk)
            return std::nullopt;
        both = redrawingBy(*walk, overflow);
    } else {
        both = {[one, other](TriangleRuns &triangle) {
                    one.change(triangle);
                    other.change(triangle);
                },
                overflow};
    }
    const bool isToggling
        = one.repainting == Repainting::Toggles || other.repainting == Repainting::Toggles;
    both.repainting = isToggling ? Repainting::Toggles : Repainting::Over;
    both.edgeTest = one.edgeTest;
    both.box = one.box == VisitedBox::OfScene ? other.box : one.box;
    both.bytes = one.bytes.isRight() ? other.bytes : one.bytes;
    return both;
}

} // namespace pixelplumb
