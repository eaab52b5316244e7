// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentspans.h"

/// The loops of a student's program.
namespace pixelplumb::studentloops {

template <class Number>
class ColumnLoops : SpanLoop<Number> {
    using SpanLoop<Number>::has;
    using SpanLoop<Number>::quotient;
    using SpanLoop<Number>::stored;
    using SpanLoop<Number>::storedPlace;
    using SpanLoop<Number>::drawSpan;
    enum class Side { First, Second, Long };

public:
    using Corners = std::array<Corner<Number>, 3>;

    /// Spans' coordinates are those of the program, or their opposites (onward = −1).
    ColumnLoops(const std::set<WalkMistake> &mistakes, int onward)
        : SpanLoop<Number>(mistakes)
        , m_onward(onward)
    {
    }

    /// Corners by x; of rows x and y have changed places.
    void draw(const Corners &given, const Paint &paint)
    {
        Corners corners = sorted(given);
        for (std::size_t i = 0; i < 3 && has(WalkMistake::UnsortedColours); ++i)
            corners[i].colour = given[i].colour;
        const auto &[p0, p1, p2] = corners;
        const bool givesUp = (has(WalkMistake::ReturnsAtFirstVertical) && p0.x == p1.x)
            || (has(WalkMistake::ReturnsAtLastVertical) && p1.x == p2.x);
        if (givesUp)
            return;
        int begin = ceilOf(p0.x);
        if (has(WalkMistake::FirstSpanMissing))
            ++begin;
        if (has(WalkMistake::OpenAtFirstVertex))
            begin = floorOf(p0.x) + 1;
        int endOfFirst = ceilOf(p1.x);
        if (has(WalkMistake::FirstHalfTruncated))
            endOfFirst = floorOf(p1.x);
        if (has(WalkMistake::FirstHalfWithMiddle))
            endOfFirst = floorOf(p1.x) + 1;
        const bool isSorted = p0.x <= p1.x && p1.x <= p2.x;
        int beginOfSecond = isSorted ? std::max(begin, ceilOf(p1.x)) : ceilOf(p1.x);
        if (has(WalkMistake::SecondHalfAfterCeiling))
            beginOfSecond = ceilOf(p1.x) + 1;
        if (has(WalkMistake::SecondHalfAfterFloor))
            beginOfSecond = floorOf(p1.x) + 1;
        int end = floorOf(p2.x) + 1;
        if (has(WalkMistake::LastSpanMissing))
            end = floorOf(p2.x);
        if (has(WalkMistake::OpenAtLastVertex))
            end = ceilOf(p2.x);
        if (has(WalkMistake::LoopsTruncated)) {
            begin = truncated(p0.x);
            endOfFirst = truncated(p1.x);
            beginOfSecond = std::max(begin, endOfFirst);
            end = truncated(p2.x) + 1;
        }
        this->isMiddleBelow = (p1.y - p0.y) * (p2.x - p0.x) <= (p2.y - p0.y) * (p1.x - p0.x);
        if (has(WalkMistake::SidesByFirstVertex))
            this->isMiddleBelow = p1.y < p0.y;
        if (has(WalkMistake::SidesByLastVertex))
            this->isMiddleBelow = p1.y < p2.y;
        Bound<Number> ofLong = edgeAt(Side::Long, p0, p2, begin);
        Bound<Number> ofShort = edgeAt(Side::First, p0, p1, begin);
        const Bound<Number> steppedLong = ofLong;
        if (has(WalkMistake::LongPlaceWaits))
            ofLong.slope = 0;
        if (has(WalkMistake::LongColoursWait))
            ofLong.step = {};
        for (int x = begin; x < (isSorted ? std::min(endOfFirst, end) : endOfFirst); ++x)
            doSpan(x, ofShort, ofLong,
                   has(WalkMistake::NoFirstHalf) ? Paint([](int, int, Colour) {}) : paint);
        ofLong.slope = steppedLong.slope;
        ofLong.step = steppedLong.step;
        const bool skipsSpans = has(WalkMistake::SecondHalfAfterCeiling)
            || has(WalkMistake::SecondHalfAfterFloor) || has(WalkMistake::FirstHalfTruncated);
        if (skipsSpans)
            ofLong = edgeAt(Side::Long, p0, p2, beginOfSecond);
        if (has(WalkMistake::NoSecondHalfAtVertical) && p1.x == p2.x)
            return;
        goOnBehind(corners, beginOfSecond, ofShort, ofLong);
        for (int x = beginOfSecond; x < end && !has(WalkMistake::NoSecondHalf); ++x)
            doSpan(x, ofShort, ofLong, paint);
    }

private:
    Corners sorted(Corners corners) const
    {
        if (has(WalkMistake::NotSorted))
            return corners;
        if (has(WalkMistake::SortedByComparisons))
            return compared(corners);
        std::stable_sort(corners.begin(), corners.end(), [&](const auto &a, const auto &b) {
            if (has(WalkMistake::SortedByTheOther))
                return a.y < b.y;
            if (a.x != b.x || has(WalkMistake::EqualAsGiven))
                return a.x < b.x;
            return has(WalkMistake::EqualDescending) ? b.y < a.y : a.y < b.y;
        });
        return corners;
    }

    /// Some of the comparisons of a sort, in this order.
    Corners compared(Corners corners) const
    {
        const auto compare = [&](WalkMistake made, std::size_t first, std::size_t second) {
            if (has(made) && corners[second].x < corners[first].x)
                std::swap(corners[first], corners[second]);
        };
        compare(WalkMistake::Compares12First, 1, 2);
        compare(WalkMistake::Compares01, 0, 1);
        compare(WalkMistake::Compares02, 0, 2);
        compare(WalkMistake::Compares12Last, 1, 2);
        return corners;
    }

    /// At the middle vertex the second short edge begins.
    void goOnBehind(const Corners &corners, int x, Bound<Number> &ofShort,
                    Bound<Number> &ofLong) const
    {
        const auto &[p0, p1, p2] = corners;
        Bound<Number> behind = edgeAt(Side::Second, p1, p2, x);
        if (p0.x != p1.x && takesOtherRates())
            behind = secondEdgeOfOtherRates(corners, x);
        if (has(WalkMistake::SecondEdgeOfFirstPlace))
            behind.y += p0.y - p1.y;
        if (p0.x != p1.x && has(WalkMistake::SecondPlaceCarriedOn))
            behind.y = ofShort.y;
        if (p0.x != p1.x && has(WalkMistake::SecondColoursCarriedOn))
            behind.colour = ofShort.colour;
        for (std::size_t i = 0; i < 3 && has(WalkMistake::SecondEdgeOfFirstColour); ++i)
            behind.colour[i] += p0.colour[i] - p1.colour[i];
        if (p1.x == p2.x && has(WalkMistake::FlatEndFromEdges))
            return;
        ofShort = behind;
        if (p1.x == p2.x && has(WalkMistake::FlatEndFromVertices))
            ofLong = {p2.y, 0, p2.colour, {}};
        const Number way = p2.x == p0.x ? Number(0) : Number(x - p1.x);
        if (has(WalkMistake::LongPlaceBegunAgain))
            ofLong.y = p1.y + way * ofLong.slope;
        for (std::size_t i = 0; i < 3 && has(WalkMistake::LongColoursBegunAgain); ++i)
            ofLong.colour[i] = p1.colour[i] + way * ofLong.step[i];
        if (has(WalkMistake::LongPlaceBegunAgainAtFirst))
            ofLong.y = p0.y + way * ofLong.slope;
        for (std::size_t i = 0; i < 3 && has(WalkMistake::LongColoursBegunAgainAtFirst); ++i)
            ofLong.colour[i] = p0.colour[i] + way * ofLong.step[i];
        if (has(WalkMistake::LongPlaceStands))
            ofLong.slope = 0;
        if (has(WalkMistake::LongColoursStand))
            ofLong.step = {};
    }

    bool takesOtherRates() const
    {
        return has(WalkMistake::SecondSlopeOfFirst) || has(WalkMistake::SecondStepsOfFirst)
            || has(WalkMistake::SecondRiseFromFirst) || has(WalkMistake::SecondRunFromFirst);
    }

    /// y += m and R += ΔR of L₁₂ with a mistaken m, or ΔR, too.
    Bound<Number> secondEdgeOfOtherRates(const Corners &corners, int x) const
    {
        const auto &[p0, p1, p2] = corners;
        const bool isOfFirst
            = has(WalkMistake::SecondSlopeOfFirst) || has(WalkMistake::SecondStepsOfFirst);
        const Corner<Number> &to = isOfFirst ? p1 : p2;
        const bool isRise = isOfFirst || has(WalkMistake::SecondRiseFromFirst);
        const bool isRun = isOfFirst || has(WalkMistake::SecondRunFromFirst);
        const Number run = to.x - (isRun ? p0.x : p1.x);
        const Corner<Number> &from = isRise ? p0 : p1;
        Bound<Number> bound = edgeAt(Side::Second, p1, p2, x);
        if (!has(WalkMistake::SecondStepsOfFirst)) {
            bound.slope = run == 0 ? Number(0) : Number((to.y - from.y) / run);
            bound.y = p1.y + (x - p1.x) * bound.slope;
        }
        const bool hasColours
            = has(WalkMistake::SecondStepsOfFirst) || has(WalkMistake::SecondColoursToo);
        for (std::size_t i = 0; i < 3 && hasColours; ++i) {
            bound.step[i] = run == 0 ? Number(0) : Number((to.colour[i] - from.colour[i]) / run);
            bound.colour[i] = p1.colour[i] + (x - p1.x) * bound.step[i];
        }
        return bound;
    }

    void doSpan(int x, Bound<Number> &ofShort, Bound<Number> &ofLong, const Paint &paint) const
    {
        const bool placesFirst = has(WalkMistake::PlacesSteppedFirst);
        const bool coloursFirst = has(WalkMistake::EdgeColoursSteppedFirst);
        if (placesFirst)
            advancePlace(ofShort), advancePlace(ofLong);
        if (coloursFirst)
            advanceColour(ofShort), advanceColour(ofLong);
        const bool isEmpty = !drawSpan(x, ofShort, ofLong, paint);
        if (isEmpty && has(WalkMistake::EmptySpansContinue))
            return;
        if (!placesFirst)
            advancePlace(ofShort), advancePlace(ofLong);
        if (!coloursFirst)
            advanceColour(ofShort), advanceColour(ofLong);
    }

    /// (int) of what the program has.
    int truncated(const Number &x) const { return m_onward > 0 ? floorOf(x) : ceilOf(x); }
    void advancePlace(Bound<Number> &bound) const { bound.y = storedPlace(bound.y + bound.slope); }
    void advanceColour(Bound<Number> &bound) const
    {
        for (std::size_t i = 0; i < 3; ++i)
            bound.colour[i] = stored(bound.colour[i] + bound.step[i], WalkMistake::WholeEdgeLevels);
    }

    /// From a vertex to the span x, as the program's pre-step and its steps behind it take it.
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

    /// Of one edge, the mistakes of the three standing in order.
    bool hasOn(Side side, WalkMistake ofFirst) const { return has(ofFirst, std::size_t(side)); }

    Number slopeOf(Side side, const Number &rise, Number width) const
    {
        if (has(WalkMistake::SlopesInverted))
            return rise == 0 ? Number(0) : Number(width / rise);
        if (has(WalkMistake::SlopeDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::SlopeDivisorPlusOne))
            width += 1;
        if (width <= 0 && has(WalkMistake::SlopeDivisorMinusOne))
            return 0;
        Number slope = rise / width;
        if (has(WalkMistake::WholeSlopes) || hasOn(side, WalkMistake::WholeSlopeOfFirst))
            slope = quotient(slope);
        if (has(WalkMistake::RoundedSlopes))
            slope = floorOf(Number(slope + Number(1) / 2));
        const bool isNegated
            = has(WalkMistake::SlopesNegated) || hasOn(side, WalkMistake::SlopeOfFirstNegated);
        return isNegated ? Number(-slope) : slope;
    }

    Bound<Number> edgeAt(Side side, const Corner<Number> &from, const Corner<Number> &to,
                         int x) const
    {
        Bound<Number> bound{storedPlace(from.y), 0, from.colour, {}};
        Number width = to.x - from.x;
        if (width == 0)
            return bound;
        if (has(WalkMistake::EdgeDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::EdgeDivisorPlusOne))
            width += 1;
        if (width == 0 || (has(WalkMistake::EdgeDivisorMinusOne) && width < 0))
            return bound;
        Number way = wayTo(side, x, from.x);
        bound.slope = slopeOf(side, to.y - from.y, width);
        const Number wayOfPlace
            = has(WalkMistake::PlaceWithoutPreStep) ? Number(x - ceilOf(from.x)) : way;
        bound.y = storedPlace(from.y + wayOfPlace * bound.slope);
        if (has(WalkMistake::ColourDivisorMinusOne))
            width -= 1;
        if (has(WalkMistake::ColourDivisorPlusOne))
            width += 1;
        if (width <= 0 && has(WalkMistake::ColourDivisorMinusOne))
            return bound;
        if (has(WalkMistake::NoEdgeColourPreStep))
            way = x - ceilOf(from.x);
        for (std::size_t i = 0; i < 3; ++i) {
            bound.step[i] = (to.colour[i] - from.colour[i]) / width;
            if (has(WalkMistake::WholeEdgeColours))
                bound.step[i] = quotient(bound.step[i]);
            bound.colour[i]
                = stored(bound.colour[i] + way * bound.step[i], WalkMistake::WholeEdgeLevels);
            if (has(WalkMistake::RedNotSteppedAlongEdges, i))
                bound.step[i] = 0;
        }
        return bound;
    }

    int m_onward;
};

} // namespace pixelplumb::studentloops
