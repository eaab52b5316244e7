// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentspans.h"

/// What a student's program does along the three edges.
namespace pixelplumb::studentloops {

enum class Side { First, Second, Long };

template <class Number>
class EdgeSteps : public SpanLoop<Number> {
    using SpanLoop<Number>::quotient;
    using SpanLoop<Number>::stored;

public:
    using SpanLoop<Number>::has;
    using Corners = std::array<Corner<Number>, 3>;

    /// Span coordinates are the program's own (onward = 1) or negated (onward = −1).
    EdgeSteps(const std::set<WalkMistake> &mistakes, int onward)
        : SpanLoop<Number>(mistakes)
        , m_onward(onward)
    {
    }

    /// (int) of the program's own coordinate.
    int truncated(const Number &x) const { return m_onward > 0 ? floorOf(x) : ceilOf(x); }
    /// round() of the program's own coordinate.
    int nearestSpan(const Number &x) const
    {
        return m_onward > 0 ? nearestOf(x) : -nearestOf(Number(-x));
    }
    void advancePlace(Bound<Number> &bound) const
    {
        bound.y = stored(storedPlace(bound.y + bound.slope), WalkMistake::PlacesCutBehindSteps,
                         WalkMistake::PlacesRoundedBehindSteps);
    }
    void advanceColour(Bound<Number> &bound) const
    {
        for (std::size_t i = 0; i < 3; ++i)
            bound.colour[i] = stored(storedLevel(bound.colour[i] + bound.step[i]),
                                     WalkMistake::EdgeLevelsCutBehindSteps,
                                     WalkMistake::EdgeLevelsRoundedBehindSteps);
    }

    Bound<Number> edgeAt(Side side, const Corner<Number> &from, const Corner<Number> &to,
                         int x) const
    {
        Bound<Number> bound{storedPlace(from.y), 0, from.colour, {}};
        const Number run = to.x - from.x;
        if (run == 0)
            return bound;
        const std::optional<Number> width = divisorOf(run, from, to);
        if (!width)
            return bound;
        const Number way = wayTo(side, x, from.x);
        const Corner<Number> &otherTo = side == Side::Long ? corners[1] : corners[2];
        const Number otherRun = otherTo.x - corners[0].x;
        const Number rise
            = hasOn(side, WalkMistake::OtherRiseOfFirst) ? otherTo.y - corners[0].y : to.y - from.y;
        bound.slope
            = slopeOf(side, rise, hasOn(side, WalkMistake::OtherRunOfFirst) ? otherRun : *width);
        const Number wayOfPlace
            = has(WalkMistake::PlaceWithoutPreStep) ? Number(x - ceilOf(from.x)) : way;
        bound.y = storedPlace(from.y + wayOfPlace * bound.slope);
        const Number colourWidth
            = hasOn(side, WalkMistake::OtherColourRunOfFirst) ? otherRun : *width;
        const bool isOther = hasOn(side, WalkMistake::OtherColoursOfFirst);
        setColours(bound, isOther ? corners[0] : from, isOther ? otherTo : to, colourWidth);
        const std::array<Number, 3> steps = bound.step;
        if (has(WalkMistake::GreenSteppedAsRedAlongEdges))
            bound.step[1] = steps[0];
        if (has(WalkMistake::BlueSteppedAsRedAlongEdges))
            bound.step[2] = steps[0];
        if (has(WalkMistake::BlueSteppedAsGreenAlongEdges))
            bound.step[2] = steps[1];
        for (std::size_t i = 0; i < 3; ++i) {
            const bool lacksPreStep = has(WalkMistake::NoEdgeColourPreStep)
                || has(WalkMistake::RedWithoutEdgePreStep, i);
            const Number own = lacksPreStep ? Number(x - ceilOf(from.x)) : way;
            bound.colour[i] = storedLevel(from.colour[i] + own * steps[i]);
            if (has(WalkMistake::RedNotSteppedAlongEdges, i))
                bound.step[i] = 0;
        }
        return bound;
    }

    /// The slope m of an edge, 0 if it is vertical.
    static Number plainSlope(const Corner<Number> &from, const Corner<Number> &to)
    {
        return to.x == from.x ? Number(0) : Number((to.y - from.y) / (to.x - from.x));
    }
    /// Replaces the edge's slope by m.
    static void takeSlope(Bound<Number> &bound, const Corner<Number> &from, const Number &slope,
                          int x)
    {
        bound.slope = slope;
        bound.y = from.y + (x - from.x) * slope;
    }

    Corners corners; ///< sorted

private:
    Number storedPlace(const Number &y) const
    {
        return stored(y, WalkMistake::WholePlaces, WalkMistake::RoundedPlaces);
    }
    Number storedLevel(const Number &level) const
    {
        return stored(level, WalkMistake::WholeEdgeLevels, WalkMistake::RoundedEdgeLevels);
    }

    /// x₁ − x₀, or what the program uses in its place; nothing if it does not step.
    std::optional<Number> divisorOf(Number run, const Corner<Number> &from,
                                    const Corner<Number> &to) const
    {
        if (has(WalkMistake::RunsOfWholeEnds))
            run = truncated(to.x) - truncated(from.x);
        if (has(WalkMistake::EdgeDivisorMinusOne))
            run -= 1;
        if (has(WalkMistake::EdgeDivisorPlusOne))
            run += 1;
        if (run == 0 || (has(WalkMistake::EdgeDivisorMinusOne) && run < 0))
            return std::nullopt;
        return run;
    }

    void setColours(Bound<Number> &bound, const Corner<Number> &from, const Corner<Number> &to,
                    Number width) const
    {
        if (has(WalkMistake::EdgeColoursByRise) || has(WalkMistake::EdgeColoursByLengthOfRise))
            width = to.y - from.y;
        if (has(WalkMistake::EdgeColoursByLengthOfRise) && width < 0)
            width = -width;
        if (has(WalkMistake::ColourDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::ColourDivisorPlusOne))
            width += 1;
        if (width == 0 || (width < 0 && has(WalkMistake::ColourDivisorMinusOne)))
            return;
        for (std::size_t i = 0; i < 3; ++i) {
            bound.step[i] = (to.colour[i] - from.colour[i]) / width;
            if (has(WalkMistake::WholeEdgeColours))
                bound.step[i] = quotient(bound.step[i]);
            if (has(WalkMistake::RoundedEdgeColours))
                bound.step[i] = nearestOf(bound.step[i]);
            if (has(WalkMistake::EdgeColoursNegated))
                bound.step[i] = -bound.step[i];
        }
        if (has(WalkMistake::BlueRateOfGreenAlongEdges))
            bound.step[2] = bound.step[1];
        if (has(WalkMistake::GreenRateOfRedAlongEdges))
            bound.step[1] = bound.step[0];
        if (has(WalkMistake::BlueRateOfRedAlongEdges))
            bound.step[2] = bound.step[0];
    }

    /// The distance from a vertex to span x, as the program's pre-step and later steps compute it.
    Number wayTo(Side side, int x, const Number &from) const
    {
        const int first = has(WalkMistake::LoopsTruncated) ? truncated(from) : ceilOf(from);
        Number preStep = first - from;
        const bool lacksPreStep = has(WalkMistake::NoEdgePreStep)
            || has(WalkMistake::LoopsTruncated) || hasOn(side, WalkMistake::NoPreStepOfFirst);
        if (lacksPreStep)
            preStep = 0;
        if (has(WalkMistake::EdgePreStepOfFraction))
            preStep = from - floorOf(from);
        if (has(WalkMistake::EdgePreStepBackward))
            preStep = -preStep;
        return preStep + (x - first);
    }

    /// Whether one edge has a mistake; those of the three edges follow one another.
    bool hasOn(Side side, WalkMistake ofFirst) const { return has(ofFirst, std::size_t(side)); }

    Number slopeOf(Side side, const Number &rise, Number width) const
    {
        if (has(WalkMistake::SlopesInverted))
            return rise == 0 ? Number(0) : Number(width / rise);
        if (has(WalkMistake::SlopeDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::SlopeDivisorPlusOne))
            width += 1;
        if (width == 0 || (width < 0 && has(WalkMistake::SlopeDivisorMinusOne)))
            return 0;
        Number slope = rise / width;
        if (has(WalkMistake::SlopesOfMagnitudes) && rise < 0)
            slope = -slope;
        if (has(WalkMistake::WholeSlopes) || hasOn(side, WalkMistake::WholeSlopeOfFirst))
            slope = quotient(slope);
        if (has(WalkMistake::RoundedSlopes))
            slope = floorOf(Number(slope + Number(1) / 2));
        const bool isNegated
            = has(WalkMistake::SlopesNegated) || hasOn(side, WalkMistake::SlopeOfFirstNegated);
        return isNegated ? Number(-slope) : slope;
    }

    int m_onward;
};

} // namespace pixelplumb::studentloops
