// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"
#include "core/number/commonfraction.h"
#include "core/scan/variedscan.h"

#include <algorithm>

namespace pixelplumb {

/// A program's walk in fractions. Of coordinates up to 2^15 px an edge's numerators stay below
/// 2^48 and its denominator, ΔX·S, below 2^33.
struct ExactWalk {
    static bool represents(const LatticePoint &point) { return isNarrow(point); }

    /// Where an edge meets the span in hand.
    class Edge {
    public:
        Edge(const Vertex &from, const Vertex &to, const WalkedProgram &program, std::int64_t span)
            : m_ofPlaces(program.placesOf(from, to))
            , m_ofColours(program.coloursOf(from, to))
            , m_walk(program.walk)
            , m_width(m_ofPlaces.b.position.x - m_ofPlaces.a.position.x)
            , m_span(span)
        {
            m_denominator = Int128(std::max<Lattice>(m_width, 1)) * unitsPerPixel;
            update();
        }

        void stepToNextSpan()
        {
            ++m_span;
            update();
        }

        bool isBelow(const Edge &other) const
        {
            return m_along * other.m_denominator < other.m_along * m_denominator;
        }
        std::int64_t floor() const { return std::int64_t(along().floor()); }
        std::int64_t ceil() const
        {
            return -std::int64_t(CommonFraction{-m_along, m_denominator}.floor());
        }
        std::int64_t nearest() const { return std::int64_t(along().nearest()); }

    private:
        friend struct ExactWalk;

        CommonFraction along() const { return {m_along, m_denominator}; }
        /// One along the spans stays at its vertex.
        void update()
        {
            const Vertex &a = m_ofPlaces.a;
            const Int128 way = m_span * unitsPerPixel - a.position.x;
            const Int128 rise = m_ofPlaces.b.position.y - a.position.y;
            if (m_width == 0)
                m_along = a.position.y;
            else if (m_walk.slopes == Quotient::Whole)
                m_along = (a.position.y + way * (rise / m_width)) * m_width;
            else
                m_along = Int128(a.position.y) * m_width + way * rise;
            for (std::size_t i = 0; i < 3; ++i)
                m_levels[i] = levelOf(i);
        }
        Int128 levelOf(std::size_t channel) const
        {
            const Int128 level = m_ofColours.a.colour.channels[channel];
            const Int128 rise = m_ofColours.b.colour.channels[channel] - level;
            const Int128 way = m_span * unitsPerPixel - m_ofColours.a.position.x;
            if (m_width == 0)
                return level * unitsPerPixel;
            if (m_walk.edgeColours == Quotient::Whole)
                return (level * unitsPerPixel + way * (rise * unitsPerPixel / m_width)) * m_width;
            return (level * m_width + way * rise) * unitsPerPixel;
        }

        VariedScan::Edge m_ofPlaces, m_ofColours;
        const ProgramWalk &m_walk;
        Lattice m_width; ///< by which is divided; 0: nothing is
        std::int64_t m_span;
        Int128 m_denominator = 1; ///< of all
        Int128 m_along = 0; ///< px
        std::array<Int128, 3> m_levels = {};
    };

    /// |y_T − y_B| over both denominators stays below 2^80, and all numerators below 2^122.
    static std::vector<WholeLevels> levelsOf(const Edge &lower, const Edge &upper,
                                             const WalkedSpan &span, const WalkedProgram &program)
    {
        const ProgramWalk &walk = program.walk;
        const Int128 unit = lower.m_denominator * upper.m_denominator;
        Int128 height = upper.m_along * lower.m_denominator - lower.m_along * upper.m_denominator;
        if (walk.divisor == SpanDivisor::HeightAndOne)
            height += unit;
        if (walk.divisor == SpanDivisor::WholeSteps)
            height = (span.end - 1 - span.first) * unit;
        const Int128 sign = height < 0 ? -1 : 1;
        const bool isFlat = height == 0; // nothing to share out
        height = isFlat ? 1 : sign * height;
        const Int128 denominator = lower.m_denominator * height;
        const bool hasPreStep = !isFlat && program.hasColourPreStep();
        const Int128 way = hasPreStep ? span.first * lower.m_denominator - lower.m_along : 0;
        std::vector<WholeLevels> levels(std::size_t(span.endDrawn - span.firstDrawn));
        for (std::size_t i = 0; i < 3; ++i) {
            const Int128 rise = isFlat ? 0
                                       : sign
                    * (upper.m_levels[i] * lower.m_denominator
                       - lower.m_levels[i] * upper.m_denominator);
            const Int128 whole = rise / height;
            const bool isPreStepWhole = walk.preSteps == Quotient::Whole;
            const Int128 first
                = lower.m_levels[i] * height + way * (isPreStepWhole ? whole * height : rise);
            const Int128 step
                = walk.steps == Quotient::Whole ? whole * denominator : rise * lower.m_denominator;
            for (std::size_t place = 0; place < levels.size(); ++place) {
                const Int128 steps = span.firstDrawn - span.first + std::int64_t(place);
                const CommonFraction level{first + steps * step, denominator};
                levels[place][i] = std::int64_t(
                    program.rounding == ByteRounding::Nearest ? level.nearest() : level.floor());
            }
        }
        return levels;
    }
};

} // namespace pixelplumb
