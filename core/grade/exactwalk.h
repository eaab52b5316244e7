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

    /// What is left of a quotient; its denominator is positive.
    static Int128 cut(const Int128 &numerator, const Int128 &denominator, Kept kept)
    {
        return kept == Kept::Down ? floorDivide(numerator, denominator) : numerator / denominator;
    }

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
            // What is lost of stored levels adds up from the edge's first span on.
            if (storesWholeLevels())
                m_span = std::min(ceilPixel(m_ofColours.a.position.x), span);
            for (std::size_t i = 0; i < 3; ++i)
                m_levels[i] = storedLevel(levelOf(i, m_span));
            update();
            while (m_span < span)
                stepToNextSpan();
        }

        void stepToNextSpan()
        {
            ++m_span;
            for (std::size_t i = 0; i < 3; ++i)
                m_levels[i]
                    = storedLevel(m_levels[i] + levelOf(i, m_span) - levelOf(i, m_span - 1));
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
            else if (m_walk.slopes != Kept::All)
                m_along = (a.position.y + way * cut(rise, m_width, m_walk.slopes)) * m_width;
            else
                m_along = Int128(a.position.y) * m_width + way * rise;
        }
        bool storesWholeLevels() const { return m_walk.edgeLevels != Kept::All; }
        Int128 storedLevel(const Int128 &level) const
        {
            return storesWholeLevels()
                ? cut(level, m_denominator, m_walk.edgeLevels) * m_denominator
                : level;
        }
        Int128 levelOf(std::size_t channel, std::int64_t span) const
        {
            const Int128 level = m_ofColours.a.colour.channels[channel];
            const Int128 rise = m_ofColours.b.colour.channels[channel] - level;
            const Int128 way = span * unitsPerPixel - m_ofColours.a.position.x;
            if (m_width == 0)
                return level * unitsPerPixel;
            if (m_walk.edgeColours != Kept::All)
                return (level * unitsPerPixel
                        + way * cut(rise * unitsPerPixel, m_width, m_walk.edgeColours))
                    * m_width;
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

    static const Edge &moved(const Edge &edge, double) { return edge; } // has no side

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
            const Int128 preStep
                = walk.preSteps == Kept::All ? rise : cut(rise, height, walk.preSteps) * height;
            const Int128 first = lower.m_levels[i] * height + way * preStep;
            const Int128 step = walk.steps == Kept::All
                ? rise * lower.m_denominator
                : cut(rise, height, walk.steps) * denominator;
            if (walk.levels != Kept::All) {
                storeWhole({first, step, denominator}, span, walk.levels, levels, i);
                continue;
            }
            for (std::size_t place = 0; place < levels.size(); ++place) {
                const Int128 steps = span.firstDrawn - span.first + std::int64_t(place);
                const CommonFraction level{first + steps * step, denominator};
                levels[place][i] = std::int64_t(
                    program.rounding == ByteRounding::Nearest ? level.nearest() : level.floor());
            }
        }
        return levels;
    }

private:
    struct Ramp {
        Int128 first, step, denominator;
    };
    /// A channel whose level is a whole number at each sample.
    static void storeWhole(const Ramp &ramp, const WalkedSpan &span, Kept kept,
                           std::vector<WholeLevels> &levels, std::size_t channel)
    {
        Int128 level = cut(ramp.first, ramp.denominator, kept);
        for (std::int64_t place = span.first; place < span.endDrawn; ++place) {
            if (place >= span.firstDrawn)
                levels[std::size_t(place - span.firstDrawn)][channel] = std::int64_t(level);
            level = cut(level * ramp.denominator + ramp.step, ramp.denominator, kept);
        }
    }
};

} // namespace pixelplumb
