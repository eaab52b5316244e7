// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/mistakenedge.h"
#include "core/scan/mistakes/mistakenlevels.h"

#include <optional>

namespace pixelplumb {

/// A program's walk in one kind of numbers: the steps of the scan in numbers that round, or the
/// same steps in fractions.
template <class Value>
struct MistakenNumbers {
    using Number = Value;
    using A = RoundedArithmetic<Value>;
    using Traits = NumberTraits<Value>;

    static bool represents(const LatticePoint &point) { return A::represents(point); }

    using Edge = MistakenEdge<Value>;
    using Bounds = WalkedBounds<Edge>;

    /// Shifts an edge to a side of rounding, which is walked in float64.
    static Edge moved(Edge edge, double along)
    {
        if constexpr (std::is_same_v<Value, double>)
            edge.moveBy(along);
        return edge;
    }
    static Value upward(const WalkedProgram &program, const Value &rate, const Value &height)
    {
        if constexpr (std::is_same_v<Value, double>)
            return program.side().upward(rate, height);
        return Traits::fromInteger(0);
    }
    static Value carriedUpward(const WalkedProgram &program, const Value &rate, const Value &height)
    {
        if constexpr (std::is_same_v<Value, double>)
            return program.side().carriedUpward(rate, height);
        return Traits::fromInteger(0);
    }

    /// R G B just after a span's last sample, and how far rounding may have moved them.
    struct Carried {
        std::array<Value, 3> levels, errors;
    };

    static void fill(SpanLevels<Value> &levels, const Bounds &bounds, const WalkedSpan &span,
                     const WalkedProgram &program, std::optional<Carried> &carried)
    {
        const ScanBugs &bugs = program.bugs();
        const bool goesOn = bugs.spanStart != SpanStart::AtBound;
        // Pre-step and steps use one rate: the first sample in the frame is reached at once, as in
        // the scan.
        const bool isReachedAtOnce = bugs.preSteps == bugs.steps && bugs.levels == Truncation::All
            && bugs.spanPreStep == PreStep::ToSample && bugs.unsteppedAlongSpans.isEmpty()
            && bugs.withoutSpanPreStep.isEmpty() && bugs.stepsAlongSpansOf == ChannelSource::Own
            && !isFlat(bugs.spanColours) && !goesOn;
        const Value height = heightOf(bounds, span, bugs.divisor);
        const std::array<Value, 3> rates = ratesOf(bounds, height, bugs);
        const std::int64_t reached = isReachedAtOnce ? span.firstDrawn : span.first;
        Carried behind;
        for (std::size_t i = 0; i < 3; ++i) {
            Ramp ramp = rampOf(bounds, reached, rates, program, i);
            ramp.error = upward(program, rates[i], height);
            behind.errors[i] = carriedUpward(program, rates[i], height);
            if (carried) {
                ramp.level = carried->levels[i];
                ramp.error = ramp.error + carried->errors[i];
                behind.errors[i] = behind.errors[i] + carried->errors[i];
            }
            if (bugs.spanStoring != Storing::BehindSteps && !isOfAdded(bugs.spanStoring))
                ramp.level = leftOf(ramp.level, bugs.levels);
            if (bugs.spanStepping == Stepping::BeforeDrawing)
                stepBy(ramp.level, ramp.step);
            const Value last = storeLevels(ramp, reached, span, program, levels, i);
            if (goesOn)
                behind.levels[i] = carriedOn(last);
        }
        if (goesOn)
            carried = behind;
    }

private:
    /// What the next span goes on with: fractions are rounded to 2^−32, or they would grow.
    static Value carriedOn(const Value &level)
    {
        if constexpr (std::is_same_v<Value, Fraction>)
            return Value((level * Value(std::int64_t(1) << 32)).nearest(), Int128(1) << 32);
        return level;
    }

    using Ramp = LevelRamp<Value>;

    static Value levelAt(const Edge &edge, std::size_t channel, Truncation kept)
    {
        return leftOf(edge.level(channel), kept);
    }

    static std::array<Value, 3> ratesOf(const Bounds &bounds, const Value &height,
                                        const ScanBugs &bugs)
    {
        const Value none = Traits::fromInteger(0);
        std::array<Value, 3> rates = {none, none, none};
        if (height == none || isFlat(bugs.spanColours))
            return rates;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t source = sourceOf(i, bugs.ratesAlongSpansOf);
            const Value atLower = levelAt(bounds.lowerColours, source, bugs.bounds);
            const Value atUpper = levelAt(bounds.upperColours, source, bugs.bounds);
            const bool isFalling = bugs.spanColours == SpanColours::Falling;
            rates[i] = (isFalling ? atLower - atUpper : atUpper - atLower) / height;
        }
        return rates;
    }

    static Ramp rampOf(const Bounds &bounds, std::int64_t reached,
                       const std::array<Value, 3> &rates, const WalkedProgram &program,
                       std::size_t channel)
    {
        const ScanBugs &bugs = program.bugs();
        const Value none = Traits::fromInteger(0);
        const Value step = bugs.unsteppedAlongSpans.contains(channel)
            ? none
            : leftOf(rates[sourceOf(channel, bugs.stepsAlongSpansOf)], bugs.steps);
        const Value from = startOf(bounds, bugs, channel);
        if (bugs.withoutSpanPreStep.contains(channel))
            return {from, step, none, from};
        const PreStep preStep = bugs.spanPreStep;
        const Value way = preStepOf(bounds.lower.place(), reached, preStep);
        const Value preStepped
            = preStep == PreStep::WithoutRate ? way : way * leftOf(rates[channel], bugs.preSteps);
        return {from + preStepped, step, none, from};
    }

    /// R at the bound, or what replaces it.
    static Value startOf(const Bounds &bounds, const ScanBugs &bugs, std::size_t channel)
    {
        const Value atLower = levelAt(bounds.lowerColours, channel, bugs.bounds);
        const Value atUpper = levelAt(bounds.upperColours, channel, bugs.bounds);
        if (bugs.spanColours == SpanColours::Mean)
            return (atLower + atUpper) / Traits::fromInteger(2);
        const bool isFromUpper = bugs.spanColours == SpanColours::FromUpperBound
            || bugs.spanColours == SpanColours::UpperAlone;
        return isFromUpper ? atUpper : atLower;
    }

    static Value heightOf(const Bounds &bounds, const WalkedSpan &span, SpanDivisor divisor)
    {
        const Value height = bounds.upper.place() - bounds.lower.place();
        switch (divisor) {
        case SpanDivisor::Height:
            break;
        case SpanDivisor::HeightAndOne:
            return height + Traits::fromInteger(1);
        case SpanDivisor::HeightLessOne:
            return height - Traits::fromInteger(1);
        case SpanDivisor::HeightFromOne:
            return height < Traits::fromInteger(1) ? Traits::fromInteger(0) : height;
        case SpanDivisor::HeightOfFloors:
            return Traits::fromInteger(A::floor(bounds.upper.place())
                                       - A::floor(bounds.lower.place()));
        case SpanDivisor::Samples:
            return Traits::fromInteger(span.end - span.first);
        case SpanDivisor::Steps:
            return Traits::fromInteger(span.end - 1 - span.first);
        }
        return height;
    }
    static Value preStepOf(const Value &lower, std::int64_t sample, PreStep preStep)
    {
        const Value at = Traits::fromInteger(sample);
        switch (preStep) {
        case PreStep::ToSample:
        case PreStep::WithoutRate:
            break;
        case PreStep::Backward:
            return lower - at;
        case PreStep::Fraction:
            return lower - Traits::fromInteger(A::floor(lower));
        case PreStep::None:
            return Traits::fromInteger(0);
        }
        return at - lower;
    }
};

} // namespace pixelplumb
