// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/variedscan.h"

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
    static Value quotient(const Value &value, Quotient kind)
    {
        return kind == Quotient::Whole ? cast(value) : value;
    }

    class Edge {
    public:
        Edge(const Vertex &from, const Vertex &to, const WalkedProgram &program, std::int64_t span)
            : Edge(program.placesOf(from, to), program.coloursOf(from, to), program.walk, span)
        {
        }

        void stepToNextSpan()
        {
            A::advance(m_along, m_slope);
            for (std::size_t i = 0; i < 3; ++i)
                A::advance(m_levels[i], m_rates[i]);
        }

        bool isBelow(const Edge &other) const { return m_along < other.m_along; }
        std::int64_t floor() const { return A::floor(m_along); }
        std::int64_t ceil() const { return A::ceil(m_along); }
        std::int64_t nearest() const { return A::level(m_along, ByteRounding::Nearest); }

    private:
        friend struct RoundedWalk;

        Edge(const VariedScan::Edge &places, const VariedScan::Edge &colours,
             const ProgramWalk &walk, std::int64_t span)
            : m_slope(quotient(A::edgeSlope(places.a, places.b), walk.slopes))
            , m_along(A::edgeOrdinate(places.a, places.b, A::runTo(span, places.a), m_slope))
        {
            const auto &[a, b] = colours;
            for (std::size_t i = 0; i < 3; ++i) {
                m_rates[i] = quotient(A::edgeColourRate(a, b, i), walk.edgeColours);
                m_levels[i] = A::edgeColour(a, b, i, A::runTo(span, a), m_rates[i]);
            }
        }

        Value m_slope; ///< px per span
        Value m_along; ///< px
        std::array<Value, 3> m_levels, m_rates;
    };

    static std::vector<WholeLevels> levelsOf(const Edge &lower, const Edge &upper,
                                             const WalkedSpan &span, const WalkedProgram &program)
    {
        const ProgramWalk &walk = program.walk;
        const Value none = Traits::fromInteger(0);
        Value height = upper.m_along - lower.m_along;
        if (walk.divisor == SpanDivisor::HeightAndOne)
            height = height + Traits::fromInteger(1);
        if (walk.divisor == SpanDivisor::WholeSteps)
            height = Traits::fromInteger(span.end - 1 - span.first);
        const Value from
            = program.hasColourPreStep() ? lower.m_along : Traits::fromInteger(span.first);
        // One rate for both: the first sample that the frame has is reached at once, as in the
        // scan.
        const std::int64_t reached = walk.preSteps == walk.steps ? span.firstDrawn : span.first;
        std::vector<WholeLevels> levels(std::size_t(span.endDrawn - span.firstDrawn));
        for (std::size_t i = 0; i < 3; ++i) {
            const Value rate
                = height == none ? none : (upper.m_levels[i] - lower.m_levels[i]) / height;
            const Value step = quotient(rate, walk.steps);
            Value level = lower.m_levels[i]
                + (Traits::fromInteger(reached) - from) * quotient(rate, walk.preSteps);
            level = level + Traits::fromInteger(span.firstDrawn - reached) * step;
            for (WholeLevels &sample : levels) {
                sample[i] = A::level(level, program.rounding);
                A::advance(level, step);
            }
        }
        return levels;
    }
};

} // namespace pixelplumb
