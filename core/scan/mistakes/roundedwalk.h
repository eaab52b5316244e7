// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/walkedprogram.h"
#include "core/scan/roundedarithmetic.h"

#include <optional>
#include <type_traits>

namespace pixelplumb {

/// A program's walk in a rounded number type, using the steps of the scan in that type.
template <class Value>
struct RoundedWalk {
    using Number = Value;
    using A = RoundedArithmetic<Value>;
    using Traits = NumberTraits<Value>;

    static bool represents(const LatticePoint &point) { return A::represents(point); }

    static Value cast(const Value &quotient)
    {
        return Traits::fromInteger(quotient < Traits::fromInteger(0) ? A::ceil(quotient)
                                                                     : A::floor(quotient));
    }
    static Value leftOf(const Value &value, Truncation kept)
    {
        if (kept == Truncation::Down)
            return Traits::fromInteger(A::floor(value));
        if (kept == Truncation::Nearest)
            return Traits::fromInteger(A::level(value, ByteRounding::Nearest));
        return kept == Truncation::TowardZero ? cast(value) : value;
    }

    class Edge {
    public:
        Edge(const WalkedEdge &edge, const ScanBugs &bugs, std::int64_t span)
            : m_bugs(bugs)
            , m_slope(leftOf(A::edgeSlope(edge.places.a, edge.places.b), bugs.slopes))
            , m_along(A::edgeOrdinate(edge.firstPlace, edge.places.b,
                                      A::runTo(span, edge.firstPlace), m_slope))
        {
            const auto &[a, b] = edge.colours;
            std::array<Value, 3> rates;
            for (std::size_t i = 0; i < 3; ++i) {
                rates[i] = leftOf(A::edgeColourRate(a, b, sourceOf(i, bugs.ratesAlongEdgesOf)),
                                  bugs.edgeColours);
                const Value run = bugs.withoutEdgePreStep.isEmpty()
                    ? A::runTo(span, edge.firstColour)
                    : Traits::fromLattice(wayToSpan(edge.firstColour.position.x, span, bugs, i));
                m_levels[i] = A::edgeColour(edge.firstColour, b, i, run, rates[i]);
            }
            if (bugs.edgeStoring == Storing::FromFirst) {
                m_along = leftOf(m_along, bugs.edgePlaces);
                for (Value &level : m_levels)
                    level = leftOf(level, bugs.edgeLevels);
            }
            for (std::size_t i = 0; i < 3; ++i)
                m_rates[i] = bugs.unsteppedAlongEdges.contains(i)
                    ? Traits::fromInteger(0)
                    : rates[sourceOf(i, bugs.stepsAlongEdgesOf)];
        }

        void stepPlace()
        {
            A::advance(m_along, m_slope);
            m_along = leftOf(m_along, m_bugs.edgePlaces);
        }
        void stepColour()
        {
            for (std::size_t i = 0; i < 3; ++i) {
                A::advance(m_levels[i], m_rates[i]);
                m_levels[i] = leftOf(m_levels[i], m_bugs.edgeLevels);
            }
        }

        void carryPlaceOf(const Edge &other) { m_along = other.m_along; }
        void carryColourOf(const Edge &other) { m_levels = other.m_levels; }
        void goOnWithPlacesOf(const Edge &other)
        {
            m_along = other.m_along;
            m_slope = other.m_slope;
        }
        void goOnWithColoursOf(const Edge &other)
        {
            m_levels = other.m_levels;
            m_rates = other.m_rates;
        }
        void stepAsPlacesOf(const Edge &other) { m_slope = other.m_slope; }
        void stepAsColoursOf(const Edge &other) { m_rates = other.m_rates; }
        void holdPlace() { m_slope = Traits::fromInteger(0); }
        void holdColour() { m_rates.fill(Traits::fromInteger(0)); }

        bool isBelow(const Edge &other) const { return m_along < other.m_along; }
        std::int64_t floor() const { return A::floor(m_along); }
        std::int64_t ceil() const { return A::ceil(m_along); }
        std::int64_t nearest() const { return A::level(m_along, ByteRounding::Nearest); }

        const Value &place() const { return m_along; } ///< px
        const Value &slope() const { return m_slope; } ///< px per span
        const std::array<Value, 3> &colour() const { return m_levels; }
        const std::array<Value, 3> &colourRate() const { return m_rates; }

    private:
        friend struct RoundedWalk;

        const ScanBugs &m_bugs;
        Value m_slope; ///< px per span
        Value m_along; ///< px
        std::array<Value, 3> m_levels, m_rates;
    };
    using Bounds = WalkedBounds<Edge>;

    /// Shifts an edge to a side of rounding, which is walked in float64.
    static Edge moved(Edge edge, double along)
    {
        if constexpr (std::is_same_v<Value, double>)
            edge.m_along += along;
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
            if (bugs.spanStoring != Storing::BehindSteps)
                ramp.level = leftOf(ramp.level, bugs.levels);
            if (bugs.spanStepping == Stepping::BeforeDrawing)
                A::advance(ramp.level, ramp.step);
            behind.levels[i] = stored(ramp, reached, span, program, levels, i);
        }
        if (goesOn)
            carried = behind;
    }

private:
    /// A level along a span: at one sample, its step, and its possible error.
    struct Ramp {
        Value level, step, error;
    };

    static Value levelAt(const Edge &edge, std::size_t channel, Truncation kept)
    {
        return leftOf(edge.m_levels[channel], kept);
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
            return {from, step, none};
        const PreStep preStep = bugs.spanPreStep;
        const Value way = preStepOf(bounds.lower.m_along, reached, preStep);
        const Value preStepped
            = preStep == PreStep::WithoutRate ? way : way * leftOf(rates[channel], bugs.preSteps);
        return {from + preStepped, step, none};
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

    /// Returns the level just after the last sample or, where that is not needed, after the last
    /// one drawn.
    static Value stored(const Ramp &ramp, std::int64_t reached, const WalkedSpan &span,
                        const WalkedProgram &program, SpanLevels<Value> &levels,
                        std::size_t channel)
    {
        const ScanBugs &bugs = program.bugs();
        const bool goesOn = bugs.spanStart != SpanStart::AtBound;
        const Truncation kept
            = bugs.spanStoring == Storing::FirstAlone ? Truncation::All : bugs.levels;
        Value level = ramp.level;
        std::int64_t place = reached;
        if (kept == Truncation::All && !goesOn) {
            level = level + Traits::fromInteger(span.firstDrawn - reached) * ramp.step;
            place = span.firstDrawn;
        }
        levels.first[channel] = level;
        levels.step[channel] = ramp.step;
        for (; place < (goesOn ? span.end : span.endDrawn); ++place) {
            if (place == span.firstDrawn)
                levels.first[channel] = level;
            if (place >= span.firstDrawn && place < span.endDrawn) {
                const auto sample = std::size_t(place - span.firstDrawn);
                levels.whole[sample][channel] = A::level(level + ramp.error, program.rounding());
                if (levels.hasNumbers())
                    levels.own[sample][channel] = level;
            }
            A::advance(level, ramp.step);
            level = leftOf(level, kept);
        }
        return level;
    }

    static Value heightOf(const Bounds &bounds, const WalkedSpan &span, SpanDivisor divisor)
    {
        const Value height = bounds.upper.m_along - bounds.lower.m_along;
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
            return Traits::fromInteger(A::floor(bounds.upper.m_along)
                                       - A::floor(bounds.lower.m_along));
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
