// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/studentnumbers.h"
#include "tests/support/studentwalk.h"

#include <algorithm>
#include <functional>
#include <optional>

/// What a student's program does with one column or row.
namespace pixelplumb::studentloops {

using Paint = std::function<void(int span, int sample, Colour colour)>;

template <class Number>
class SpanLoop {
public:
    explicit SpanLoop(const std::set<WalkMistake> &mistakes)
        : m_mistakes(mistakes)
    {
    }

    bool has(WalkMistake mistake) const { return m_mistakes.contains(mistake); }
    /// Whether one channel has a mistake; those of the three channels follow one another.
    bool has(WalkMistake ofRed, std::size_t channel) const
    {
        return has(WalkMistake(int(ofRed) + int(channel)));
    }

    Number quotient(const Number &number) const
    {
        return has(WalkMistake::DividesDown) ? Number(floorOf(number)) : cast(number);
    }
    Number stored(const Number &level, WalkMistake mistake) const
    {
        return has(mistake) ? cast(level) : level;
    }
    /// Cut with the one mistake, rounded with the other.
    Number stored(const Number &number, WalkMistake cut, WalkMistake rounds) const
    {
        return has(rounds) ? Number(nearestOf(number)) : stored(number, cut);
    }

    /// Returns whether the span has a sample.
    bool drawSpan(int x, const Bound<Number> &ofShort, const Bound<Number> &ofLong,
                  const Paint &paint)
    {
        bool isShortLower = ofShort.y != ofLong.y ? ofShort.y < ofLong.y : isMiddleBelow;
        if (has(WalkMistake::LongEdgeAlwaysUpper))
            isShortLower = true;
        if (has(WalkMistake::LongEdgeAlwaysLower))
            isShortLower = false;
        const bool isByVertex = has(WalkMistake::SidesByFirstVertex)
            || has(WalkMistake::SidesByLastVertex) || has(WalkMistake::SidesBySlopes);
        if (isByVertex)
            isShortLower = isMiddleBelow;
        const Bound<Number> &lower = isShortLower ? ofShort : ofLong;
        const Bound<Number> &upper = isShortLower ? ofLong : ofShort;
        std::array<Number, 3> atLower = lower.colour;
        std::array<Number, 3> atUpper = upper.colour;
        const bool isExchanged = has(isShortLower ? WalkMistake::LongEdgesColoursBelow
                                                  : WalkMistake::ShortEdgesColoursBelow);
        if (isExchanged || has(WalkMistake::BoundColoursExchanged))
            std::swap(atLower, atUpper);
        for (std::size_t i = 0; i < 3; ++i) {
            for (Number *each : {&atLower[i], &atUpper[i]}) {
                *each = stored(*each, WalkMistake::WholeBoundColours);
                if (has(WalkMistake::RoundedBoundColours))
                    *each = nearestOf(*each);
            }
        }
        int first = ceilOf(lower.y);
        int last = floorOf(upper.y);
        if (has(WalkMistake::LowerBoundLeftOut))
            first = floorOf(lower.y) + 1;
        if (has(WalkMistake::UpperBoundLeftOut))
            last = ceilOf(upper.y) - 1;
        if (has(WalkMistake::FirstSampleNearest))
            first = nearestOf(lower.y);
        if (has(WalkMistake::LastSampleNearest))
            last = nearestOf(upper.y);
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
        if (has(WalkMistake::SpanDivisorMinusOne))
            height -= 1;
        if (has(WalkMistake::SpanDivisorOfFloors))
            height = floorOf(upper.y) - floorOf(lower.y);
        if (has(WalkMistake::ShortSpansNotStepped) && height < 1)
            height = 0;
        if (has(WalkMistake::ColoursBetweenSamples)) {
            height = last - first;
            preStep = 0;
        }
        std::array<Number, 3> level = startOf(atLower, atUpper);
        const std::array<Number, 3> rates = ratesOf(atLower, atUpper, height);
        std::array<Number, 3> step = {};
        for (std::size_t i = 0; i < 3 && height != 0; ++i) {
            const Number &rate = rates[i];
            if (has(WalkMistake::SpanPreStepWithoutRate))
                level[i] += preStep;
            else if (!has(WalkMistake::RedWithoutPreStep, i))
                level[i] += preStep * (has(WalkMistake::WholePreSteps) ? quotient(rate) : rate);
            step[i] = has(WalkMistake::WholeSteps) ? quotient(rate) : rate;
            if (has(WalkMistake::GreenSteppedAsRed) && i == 1)
                step[i] = rates[0];
            if (has(WalkMistake::BlueSteppedAsRed) && i == 2)
                step[i] = rates[0];
            if (has(WalkMistake::BlueSteppedAsGreen) && i == 2)
                step[i] = rates[1];
            if (has(WalkMistake::RedNotSteppedAlongSpans, i))
                step[i] = 0;
            if (has(WalkMistake::ColoursSteppedFirst))
                level[i] += step[i];
        }
        if (has(WalkMistake::ColoursGoOn) || has(WalkMistake::ColoursGoOnInHalf))
            level = goneOn.value_or(level);
        for (Number &channel : level)
            channel = stored(stored(channel, WalkMistake::FirstSpanLevelCut),
                             WalkMistake::WholeSpanLevels, WalkMistake::RoundedSpanLevels);
        if (has(WalkMistake::FirstSampleTooManyOfNextColour))
            --first;
        for (int y = first; y <= last; ++y) {
            Colour colour;
            for (std::size_t i = 0; i < 3; ++i) {
                const Number rounded = level[i] + Number(1) / 2;
                colour.channels[i] = std::uint8_t(std::clamp(floorOf(rounded), 0, 255));
                level[i] = stored(level[i] + step[i], WalkMistake::WholeSpanLevels,
                                  WalkMistake::RoundedSpanLevels);
                level[i] = stored(level[i], WalkMistake::SpanLevelsCutBehindSteps,
                                  WalkMistake::SpanLevelsRoundedBehindSteps);
            }
            const int place = has(WalkMistake::FilledFromLastSample) ? last - (y - first) : y;
            if (!has(WalkMistake::OutlineAlone) || y == first || y == last)
                paint(x, place, colour);
        }
        goneOn = level;
        return first <= last;
    }

    bool isMiddleBelow = true;
    std::optional<std::array<Number, 3>> goneOn; ///< where the previous span's colours ended

private:
    std::array<Number, 3> startOf(const std::array<Number, 3> &atLower,
                                  const std::array<Number, 3> &atUpper) const
    {
        std::array<Number, 3> mean;
        for (std::size_t i = 0; i < 3; ++i)
            mean[i] = (atLower[i] + atUpper[i]) / 2;
        if (has(WalkMistake::MeanOfBounds))
            return mean;
        const bool isFromUpper
            = has(WalkMistake::ColoursFromUpperBound) || has(WalkMistake::UpperColourAlone);
        return isFromUpper ? atUpper : atLower;
    }

    std::array<Number, 3> ratesOf(const std::array<Number, 3> &atLower,
                                  const std::array<Number, 3> &atUpper, const Number &height) const
    {
        std::array<Number, 3> rates = {};
        const bool isFlat = has(WalkMistake::LowerColourAlone) || has(WalkMistake::UpperColourAlone)
            || has(WalkMistake::MeanOfBounds);
        for (std::size_t i = 0; i < 3 && height != 0 && !isFlat; ++i) {
            rates[i] = (atUpper[i] - atLower[i]) / height;
            if (has(WalkMistake::ColourStepNegated))
                rates[i] = -rates[i];
            if (has(WalkMistake::RoundedRates))
                rates[i] = nearestOf(rates[i]);
        }
        if (has(WalkMistake::BlueRateOfGreen))
            rates[2] = rates[1];
        if (has(WalkMistake::GreenRateOfRed))
            rates[1] = rates[0];
        if (has(WalkMistake::BlueRateOfRed))
            rates[2] = rates[0];
        return rates;
    }

    const std::set<WalkMistake> &m_mistakes;
};

} // namespace pixelplumb::studentloops
