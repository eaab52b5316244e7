// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/walkedprogram.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/variedscan.h"

#include <type_traits>

namespace pixelplumb {

/// A program's walk in a number that rounds, by the steps of the scan in it.
template <class Value>
struct RoundedWalk {
    using A = RoundedArithmetic<Value>;
    using Traits = NumberTraits<Value>;

    static bool represents(const LatticePoint &point) { return A::represents(point); }

    static Value cast(const Value &quotient)
    {
        return Traits::fromInteger(quotient < Traits::fromInteger(0) ? A::ceil(quotient)
                                                                     : A::floor(quotient));
    }
    static Value left(const Value &value, Kept kept)
    {
        if (kept == Kept::Down)
            return Traits::fromInteger(A::floor(value));
        if (kept == Kept::Nearest)
            return Traits::fromInteger(A::level(value, ByteRounding::Nearest));
        return kept == Kept::TowardZero ? cast(value) : value;
    }

    class Edge {
    public:
        Edge(const WalkedEdge &edge, const ProgramWalk &walk, std::int64_t span)
            : m_walk(walk)
            , m_slope(left(A::edgeSlope(edge.places.a, edge.places.b), walk.slopes))
            , m_along(left(A::edgeOrdinate(edge.firstPlace, edge.places.b,
                                           A::runTo(span, edge.firstPlace), m_slope),
                           walk.edgePlaces))
        {
            const auto &[a, b] = edge.colours;
            const Value run = A::runTo(span, edge.firstColour);
            for (std::size_t i = 0; i < 3; ++i) {
                m_rates[i] = left(A::edgeColourRate(a, b, i), walk.edgeColours);
                m_levels[i]
                    = left(A::edgeColour(edge.firstColour, b, i, run, m_rates[i]), walk.edgeLevels);
                if (walk.unsteppedAlongEdges.contains(i))
                    m_rates[i] = Traits::fromInteger(0);
            }
        }

        void stepPlace()
        {
            A::advance(m_along, m_slope);
            m_along = left(m_along, m_walk.edgePlaces);
        }
        void stepColour()
        {
            for (std::size_t i = 0; i < 3; ++i) {
                A::advance(m_levels[i], m_rates[i]);
                m_levels[i] = left(m_levels[i], m_walk.edgeLevels);
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

    private:
        friend struct RoundedWalk;

        const ProgramWalk &m_walk;
        Value m_slope; ///< px per span
        Value m_along; ///< px
        std::array<Value, 3> m_levels, m_rates;
    };
    using Bounds = WalkedBounds<Edge>;

    /// On a side of what rounding may do, which is walked in float64.
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

    static std::vector<WholeLevels> levelsOf(const Bounds &bounds, const WalkedSpan &span,
                                             const WalkedProgram &program)
    {
        const ProgramWalk &walk = program.walk();
        const Value none = Traits::fromInteger(0);
        const Value height = heightOf(bounds, span, walk.divisor);
        const PreStep preStep = program.spanPreStep();
        // One rate for both: the first sample that the frame has is reached at once, as in the
        // scan.
        const bool isReachedAtOnce = walk.preSteps == walk.steps && walk.levels == Kept::All
            && preStep == PreStep::ToSample && walk.unsteppedAlongSpans.isEmpty()
            && walk.stepsAlongSpansOf == ownChannels;
        const std::int64_t reached = isReachedAtOnce ? span.firstDrawn : span.first;
        const Value way = preStepOf(bounds.lower.m_along, reached, preStep);
        std::array<Value, 3> froms = {none, none, none}, rates = froms;
        for (std::size_t i = 0; i < 3; ++i) {
            const Value atLower = left(bounds.lowerColours.m_levels[i], walk.bounds);
            const Value atUpper = left(bounds.upperColours.m_levels[i], walk.bounds);
            const Value rise
                = walk.spanColours == SpanColours::Falling ? atLower - atUpper : atUpper - atLower;
            froms[i] = walk.spanColours == SpanColours::FromUpperBound ? atUpper : atLower;
            if (height != none)
                rates[i] = rise / height;
        }
        std::vector<WholeLevels> levels(std::size_t(span.endDrawn - span.firstDrawn));
        for (std::size_t i = 0; i < 3; ++i) {
            const Value step = walk.unsteppedAlongSpans.contains(i)
                ? none
                : left(rates[walk.stepsAlongSpansOf[i]], walk.steps);
            const Value error = upward(program, rates[i], height);
            const Value preStepped
                = preStep == PreStep::WithoutRate ? way : way * left(rates[i], walk.preSteps);
            Value level = left(froms[i] + preStepped, walk.levels);
            if (walk.spanStepping == Stepping::BeforeDrawing)
                A::advance(level, step);
            std::int64_t place = reached;
            if (walk.levels == Kept::All) {
                level = level + Traits::fromInteger(span.firstDrawn - reached) * step;
                place = span.firstDrawn;
            }
            for (; place < span.endDrawn; ++place) {
                if (place >= span.firstDrawn)
                    levels[std::size_t(place - span.firstDrawn)][i]
                        = A::level(level + error, program.rounding());
                A::advance(level, step);
                level = left(level, walk.levels);
            }
        }
        return levels;
    }

private:
    static Value heightOf(const Bounds &bounds, const WalkedSpan &span, SpanDivisor divisor)
    {
        const Value height = bounds.upper.m_along - bounds.lower.m_along;
        switch (divisor) {
        case SpanDivisor::Height:
            break;
        case SpanDivisor::HeightAndOne:
            return height + Traits::fromInteger(1);
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
