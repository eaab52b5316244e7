// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentnumbers.h"
#include "tests/support/studentwalk.h"

#include <algorithm>
#include <functional>

/// The loops of a student's program.
namespace pixelplumb::studentloops {

using Paint = std::function<void(int span, int sample, Colour colour)>;

template <class Number>
class ColumnLoops {
public:
    using Corners = std::array<Corner<Number>, 3>;

    /// Spans' coordinates are those of the program, or their opposites (onward = −1).
    ColumnLoops(const std::set<WalkMistake> &mistakes, int onward)
        : m_mistakes(mistakes)
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
        const bool isSorted = !has(WalkMistake::NotSorted) && !has(WalkMistake::SortedByTheOther);
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
        m_isMiddleBelow = (p1.y - p0.y) * (p2.x - p0.x) <= (p2.y - p0.y) * (p1.x - p0.x);
        Bound<Number> ofLong = edgeAt(p0, p2, begin);
        Bound<Number> ofShort = edgeAt(p0, p1, begin);
        for (int x = begin; x < (isSorted ? std::min(endOfFirst, end) : endOfFirst); ++x)
            doSpan(x, ofShort, ofLong,
                   has(WalkMistake::NoFirstHalf) ? Paint([](int, int, Colour) {}) : paint);
        if (isSorted && beginOfSecond != std::max(begin, endOfFirst))
            ofLong = edgeAt(p0, p2, beginOfSecond);
        if (has(WalkMistake::NoSecondHalfAtVertical) && p1.x == p2.x)
            return;
        goOnBehind(corners, beginOfSecond, ofShort, ofLong);
        for (int x = beginOfSecond; x < end && !has(WalkMistake::NoSecondHalf); ++x)
            doSpan(x, ofShort, ofLong, paint);
    }

private:
    bool has(WalkMistake mistake) const { return m_mistakes.contains(mistake); }
    /// Of one channel, the mistakes of the three standing in order.
    bool has(WalkMistake ofRed, std::size_t channel) const
    {
        return has(WalkMistake(int(ofRed) + int(channel)));
    }

    Corners sorted(Corners corners) const
    {
        if (has(WalkMistake::NotSorted))
            return corners;
        std::stable_sort(corners.begin(), corners.end(), [&](const auto &a, const auto &b) {
            if (has(WalkMistake::SortedByTheOther))
                return a.y < b.y;
            if (a.x != b.x || has(WalkMistake::EqualAsGiven))
                return a.x < b.x;
            return has(WalkMistake::EqualDescending) ? b.y < a.y : a.y < b.y;
        });
        return corners;
    }

    /// At the middle vertex the second short edge begins.
    void goOnBehind(const Corners &corners, int x, Bound<Number> &ofShort,
                    Bound<Number> &ofLong) const
    {
        const auto &[p0, p1, p2] = corners;
        Bound<Number> behind = has(WalkMistake::SecondHalfWithoutPreStep)
            ? edgeAt({Number(ceilOf(p1.x)), p1.y, p1.colour},
                     {p2.x + ceilOf(p1.x) - p1.x, p2.y, p2.colour}, x)
            : edgeAt(p1, p2, x);
        if (has(WalkMistake::SecondPlaceCarriedOn))
            behind.y = ofShort.y;
        if (has(WalkMistake::SecondColoursCarriedOn))
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
        if (has(WalkMistake::LongPlaceStands))
            ofLong.slope = 0;
        if (has(WalkMistake::LongColoursStand))
            ofLong.step = {};
    }

    void doSpan(int x, Bound<Number> &ofShort, Bound<Number> &ofLong, const Paint &paint) const
    {
        const bool stepsFirst = has(WalkMistake::EdgesSteppedFirst);
        if (stepsFirst)
            advance(ofShort), advance(ofLong);
        const bool isEmpty = !drawSpan(x, ofShort, ofLong, paint);
        if (stepsFirst || (isEmpty && has(WalkMistake::EmptySpansContinue)))
            return;
        advance(ofShort);
        advance(ofLong);
    }

    /// (int) of what the program has.
    int truncated(const Number &x) const { return m_onward > 0 ? floorOf(x) : ceilOf(x); }
    Number quotient(const Number &number) const
    {
        return has(WalkMistake::DividesDown) ? Number(floorOf(number)) : cast(number);
    }
    Number stored(const Number &level, WalkMistake mistake) const
    {
        return has(mistake) ? cast(level) : level;
    }
    Number storedPlace(const Number &y) const
    {
        if (has(WalkMistake::RoundedPlaces))
            return Number(floorOf(Number(y + Number(1) / 2)));
        return stored(y, WalkMistake::WholePlaces);
    }
    void advance(Bound<Number> &bound) const
    {
        bound.y = storedPlace(bound.y + bound.slope);
        for (std::size_t i = 0; i < 3; ++i)
            bound.colour[i] = stored(bound.colour[i] + bound.step[i], WalkMistake::WholeEdgeLevels);
    }

    /// From a vertex to the span x, as the program's pre-step and its steps behind it take it.
    Number wayTo(int x, const Number &from) const
    {
        const int first = has(WalkMistake::LoopsTruncated) ? truncated(from) : ceilOf(from);
        Number preStep = first - from;
        const bool lacksPreStep
            = has(WalkMistake::NoEdgePreStep) || has(WalkMistake::LoopsTruncated);
        if (lacksPreStep)
            preStep = 0;
        if (has(WalkMistake::EdgePreStepOfFraction))
            preStep = from - floorOf(from);
        if (has(WalkMistake::EdgePreStepBackward))
            preStep = -preStep;
        return preStep + (x - first);
    }

    Bound<Number> edgeAt(const Corner<Number> &from, const Corner<Number> &to, int x) const
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
        Number way = wayTo(x, from.x);
        bound.slope = (to.y - from.y) / width;
        if (has(WalkMistake::WholeSlopes))
            bound.slope = quotient(bound.slope);
        bound.y = storedPlace(from.y + way * bound.slope);
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

    /// Whether there is a sample.
    bool drawSpan(int x, const Bound<Number> &ofShort, const Bound<Number> &ofLong,
                  const Paint &paint) const
    {
        bool isShortLower = ofShort.y != ofLong.y ? ofShort.y < ofLong.y : m_isMiddleBelow;
        if (has(WalkMistake::LongEdgeAlwaysUpper))
            isShortLower = true;
        if (has(WalkMistake::LongEdgeAlwaysLower))
            isShortLower = false;
        const Bound<Number> &lower = isShortLower ? ofShort : ofLong;
        const Bound<Number> &upper = isShortLower ? ofLong : ofShort;
        std::array<Number, 3> atLower = lower.colour;
        std::array<Number, 3> atUpper = upper.colour;
        const bool isExchanged = has(isShortLower ? WalkMistake::LongEdgesColoursBelow
                                                  : WalkMistake::ShortEdgesColoursBelow);
        if (isExchanged)
            std::swap(atLower, atUpper);
        int first = ceilOf(lower.y);
        int last = floorOf(upper.y);
        if (has(WalkMistake::LastSampleTooMany))
            ++last;
        if (has(WalkMistake::FirstSampleTooMany))
            --first;
        Number height = upper.y - lower.y;
        if (has(WalkMistake::SpanDivisorPlusOne))
            height += 1;
        if (has(WalkMistake::SpanDivisorSamples))
            height = last - first + 1;
        if (has(WalkMistake::SpanDivisorSteps))
            height = last - first;
        Number preStep = first - lower.y;
        if (has(WalkMistake::SpanPreStepOfFraction))
            preStep = lower.y - floorOf(lower.y);
        if (has(WalkMistake::SpanPreStepBackward))
            preStep = -preStep;
        if (has(WalkMistake::ColoursBetweenSamples)) {
            height = last - first;
            preStep = 0;
        }
        std::array<Number, 3> level = atLower;
        std::array<Number, 3> step = {};
        for (std::size_t i = 0; i < 3 && height != 0; ++i) {
            const Number rate = (atUpper[i] - atLower[i]) / height;
            level[i] += preStep * (has(WalkMistake::WholePreSteps) ? quotient(rate) : rate);
            step[i] = has(WalkMistake::WholeSteps) ? quotient(rate) : rate;
            if (has(WalkMistake::RedNotSteppedAlongSpans, i))
                step[i] = 0;
            if (has(WalkMistake::ColoursSteppedFirst))
                level[i] += step[i];
        }
        for (Number &channel : level)
            channel = stored(channel, WalkMistake::WholeSpanLevels);
        if (has(WalkMistake::FirstSampleTooManyOfNextColour))
            --first;
        for (int y = first; y <= last; ++y) {
            Colour colour;
            for (std::size_t i = 0; i < 3; ++i) {
                const Number rounded = level[i] + Number(1) / 2;
                colour.channels[i] = std::uint8_t(std::clamp(floorOf(rounded), 0, 255));
                level[i] = stored(level[i] + step[i], WalkMistake::WholeSpanLevels);
            }
            if (!has(WalkMistake::OutlineAlone) || y == first || y == last)
                paint(x, y, colour);
        }
        return first <= last;
    }

    const std::set<WalkMistake> &m_mistakes;
    int m_onward;
    bool m_isMiddleBelow = true;
};

} // namespace pixelplumb::studentloops
