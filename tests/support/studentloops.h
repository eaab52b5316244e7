// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentedges.h"

/// The loops of a student's program.
namespace pixelplumb::studentloops {

template <class Number>
class ColumnLoops : EdgeSteps<Number> {
    using typename EdgeSteps<Number>::Corners;
    using EdgeSteps<Number>::has;
    using EdgeSteps<Number>::truncated;
    using EdgeSteps<Number>::nearestSpan;
    using EdgeSteps<Number>::edgeAt;
    using EdgeSteps<Number>::plainSlope;
    using EdgeSteps<Number>::takeSlope;
    using EdgeSteps<Number>::advancePlace;
    using EdgeSteps<Number>::advanceColour;

public:
    using EdgeSteps<Number>::EdgeSteps;

    /// Corners by x; for rows, x and y are swapped.
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
        this->corners = corners;
        this->goneOn.reset();
        int begin = ceilOf(p0.x);
        if (has(WalkMistake::FirstSpanFloor))
            begin = floorOf(p0.x);
        if (has(WalkMistake::FirstSpanNearest))
            begin = nearestSpan(p0.x);
        if (has(WalkMistake::FirstSpanTooMany))
            --begin;
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
        if (has(WalkMistake::SecondHalfTooEarly))
            beginOfSecond = endOfFirst = std::max(begin, floorOf(p1.x));
        if (has(WalkMistake::SecondHalfFromNearest))
            beginOfSecond = endOfFirst = std::max(begin, nearestSpan(p1.x));
        if (begin < ceilOf(p0.x) && p0.x == p1.x)
            beginOfSecond = endOfFirst = begin;
        if (has(WalkMistake::SecondHalfAfterCeiling))
            beginOfSecond = ceilOf(p1.x) + 1;
        if (has(WalkMistake::SecondHalfAfterFloor))
            beginOfSecond = floorOf(p1.x) + 1;
        int end = floorOf(p2.x) + 1;
        if (has(WalkMistake::LastSpanCeil))
            end = ceilOf(p2.x) + 1;
        if (has(WalkMistake::LastSpanNearest))
            end = nearestSpan(p2.x) + 1;
        if (has(WalkMistake::LastSpanTooMany))
            ++end;
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
        if (has(WalkMistake::SidesBySlopes))
            this->isMiddleBelow = plainSlope(p0, p1) <= plainSlope(p0, p2);
        Bound<Number> ofLong = edgeAt(Side::Long, p0, p2, begin);
        Bound<Number> ofShort = edgeAt(Side::First, p0, p1, begin);
        if (has(WalkMistake::ShortSlopesExchanged))
            takeSlope(ofShort, p0, plainSlope(p1, p2), begin);
        if (has(WalkMistake::FirstAndLongSlopesExchanged)) {
            takeSlope(ofShort, p0, plainSlope(p0, p2), begin);
            takeSlope(ofLong, p0, plainSlope(p0, p1), begin);
        }
        if (has(WalkMistake::SecondAndLongSlopesExchanged))
            takeSlope(ofLong, p0, plainSlope(p1, p2), begin);
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
        if (has(WalkMistake::ColoursGoOnInHalf))
            this->goneOn.reset();
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

    /// Makes some of the comparisons of a sort, in this order.
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

    /// Starts the second short edge at the middle vertex.
    void goOnBehind(const Corners &corners, int x, Bound<Number> &ofShort,
                    Bound<Number> &ofLong) const
    {
        const auto &[p0, p1, p2] = corners;
        Bound<Number> behind = edgeAt(Side::Second, p1, p2, x);
        if (has(WalkMistake::ShortSlopesExchanged))
            takeSlope(behind, p1, plainSlope(p0, p1), x);
        if (has(WalkMistake::SecondAndLongSlopesExchanged))
            takeSlope(behind, p1, plainSlope(p0, p2), x);
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
        if (has(WalkMistake::LongWithoutPreStepBehindMiddle)) {
            ofLong.y = p0.y + (p1.x - p0.x) * ofLong.slope;
            for (std::size_t i = 0; i < 3; ++i)
                ofLong.colour[i] = p0.colour[i] + (p1.x - p0.x) * ofLong.step[i];
        }
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
        return has(WalkMistake::SecondSlopeOfFirst) || has(WalkMistake::SecondStepsOfFirst);
    }

    /// Steps y += m and R += ΔR of L₁₂ with a wrong m, or also a wrong ΔR.
    Bound<Number> secondEdgeOfOtherRates(const Corners &corners, int x) const
    {
        const auto &[p0, p1, p2] = corners;
        const Number run = p1.x - p0.x;
        Bound<Number> bound = edgeAt(Side::Second, p1, p2, x);
        if (!has(WalkMistake::SecondStepsOfFirst)) {
            bound.slope = (p1.y - p0.y) / run;
            bound.y = p1.y + (x - p1.x) * bound.slope;
        }
        const bool hasColours
            = has(WalkMistake::SecondStepsOfFirst) || has(WalkMistake::SecondColoursToo);
        for (std::size_t i = 0; i < 3 && hasColours; ++i) {
            bound.step[i] = (p1.colour[i] - p0.colour[i]) / run;
            bound.colour[i] = p1.colour[i] + (x - p1.x) * bound.step[i];
        }
        return bound;
    }

    void doSpan(int x, Bound<Number> &ofShort, Bound<Number> &ofLong, const Paint &paint)
    {
        const bool placesFirst = has(WalkMistake::PlacesSteppedFirst);
        const bool coloursFirst = has(WalkMistake::EdgeColoursSteppedFirst);
        if (placesFirst)
            advancePlace(ofShort), advancePlace(ofLong);
        if (coloursFirst)
            advanceColour(ofShort), advanceColour(ofLong);
        const bool isEmpty = !this->drawSpan(x, ofShort, ofLong, paint);
        if (isEmpty && has(WalkMistake::EmptySpansContinue))
            return;
        if (!placesFirst)
            advancePlace(ofShort), advancePlace(ofLong);
        if (!coloursFirst)
            advanceColour(ofShort), advanceColour(ofLong);
    }
};

} // namespace pixelplumb::studentloops
