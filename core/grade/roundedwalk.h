// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"
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
        return kept == Kept::TowardZero ? cast(value) : value;
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
            for (std::size_t i = 0; i < 3; ++i) {
                A::advance(m_levels[i], m_rates[i]);
                m_levels[i] = left(m_levels[i], m_edgeLevels);
            }
        }

        bool isBelow(const Edge &other) const { return m_along < other.m_along; }
        std::int64_t floor() const { return A::floor(m_along); }
        std::int64_t ceil() const { return A::ceil(m_along); }
        std::int64_t nearest() const { return A::level(m_along, ByteRounding::Nearest); }

    private:
        friend struct RoundedWalk;

        Edge(const VariedScan::Edge &places, const VariedScan::Edge &colours,
             const ProgramWalk &walk, std::int64_t span)
            : m_edgeLevels(walk.edgeLevels)
            , m_slope(left(A::edgeSlope(places.a, places.b), walk.slopes))
            , m_along(A::edgeOrdinate(places.a, places.b, A::runTo(span, places.a), m_slope))
        {
            const auto &[a, b] = colours;
            // What is lost adds up from the edge's first span on.
            const std::int64_t first
                = m_edgeLevels == Kept::All ? span : std::min(ceilPixel(a.position.x), span);
            for (std::size_t i = 0; i < 3; ++i) {
                m_rates[i] = left(A::edgeColourRate(a, b, i), walk.edgeColours);
                m_levels[i]
                    = left(A::edgeColour(a, b, i, A::runTo(first, a), m_rates[i]), m_edgeLevels);
                for (std::int64_t stepped = first; stepped < span; ++stepped) {
                    A::advance(m_levels[i], m_rates[i]);
                    m_levels[i] = left(m_levels[i], m_edgeLevels);
                }
            }
        }

        Kept m_edgeLevels;
        Value m_slope; ///< px per span
        Value m_along; ///< px
        std::array<Value, 3> m_levels, m_rates;
    };

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
            return program.side.upward(rate, height);
        return Traits::fromInteger(0);
    }

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
        const bool isReachedAtOnce = walk.preSteps == walk.steps && walk.levels == Kept::All;
        const std::int64_t reached = isReachedAtOnce ? span.firstDrawn : span.first;
        std::vector<WholeLevels> levels(std::size_t(span.endDrawn - span.firstDrawn));
        for (std::size_t i = 0; i < 3; ++i) {
            const Value rate
                = height == none ? none : (upper.m_levels[i] - lower.m_levels[i]) / height;
            const Value step = left(rate, walk.steps);
            const Value error = upward(program, rate, height);
            Value level = lower.m_levels[i]
                + (Traits::fromInteger(reached) - from) * left(rate, walk.preSteps);
            level = left(level, walk.levels);
            std::int64_t place = reached;
            if (walk.levels == Kept::All) {
                level = level + Traits::fromInteger(span.firstDrawn - reached) * step;
                place = span.firstDrawn;
            }
            for (; place < span.endDrawn; ++place) {
                if (place >= span.firstDrawn)
                    levels[std::size_t(place - span.firstDrawn)][i]
                        = A::level(level + error, program.rounding);
                A::advance(level, step);
                level = left(level, walk.levels);
            }
        }
        return levels;
    }
};

} // namespace pixelplumb
