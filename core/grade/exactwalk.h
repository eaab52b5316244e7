// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/exacttrack.h"
#include "core/grade/walkedprogram.h"
#include "core/number/wideinteger.h"

#include <algorithm>

namespace pixelplumb {

/// A program's walk in fractions. Of coordinates up to 2^15 px an edge's denominator, ΔX·S, stays
/// below 2^33 and, where it is carried on from another's end, below 2^66; numerators below 2^90.
struct ExactWalk {
    static bool represents(const LatticePoint &point) { return isNarrow(point); }

    using Track = ExactTrack;

    /// Where an edge meets the span in hand.
    class Edge {
    public:
        Edge(const WalkedEdge &edge, const ProgramWalk &walk, std::int64_t span)
            : m_walk(walk)
        {
            const Lattice width = edge.places.b.position.x - edge.places.a.position.x;
            const Lattice rise = edge.places.b.position.y - edge.places.a.position.y;
            m_places = trackOf({edge.firstPlace.position.y, rise, walk.slopes}, width,
                               span * unitsPerPixel - edge.firstPlace.position.x);
            m_places.store(walk.edgePlaces);
            const Lattice ofColours = edge.colours.b.position.x - edge.colours.a.position.x;
            for (std::size_t i = 0; i < 3; ++i) {
                const int from = edge.colours.a.colour.channels[i];
                const int change = edge.colours.b.colour.channels[i] - from;
                const int first = edge.firstColour.colour.channels[i];
                m_levels[i]
                    = trackOf({first * unitsPerPixel, change * unitsPerPixel, walk.edgeColours},
                              ofColours, span * unitsPerPixel - edge.firstColour.position.x);
                m_levels[i].store(walk.edgeLevels);
                if (walk.unsteppedAlongEdges.contains(i))
                    m_levels[i].rate = 0;
            }
        }

        void stepPlace() { m_places.step(m_walk.edgePlaces); }
        void stepColour()
        {
            for (Track &level : m_levels)
                level.step(m_walk.edgeLevels);
        }

        void carryPlaceOf(const Edge &other) { m_places.carryOn(other.m_places); }
        void carryColourOf(const Edge &other)
        {
            for (std::size_t i = 0; i < 3; ++i)
                m_levels[i].carryOn(other.m_levels[i]);
        }
        void goOnWithPlacesOf(const Edge &other) { m_places = other.m_places; }
        void goOnWithColoursOf(const Edge &other) { m_levels = other.m_levels; }
        /// Steps from here on as another one does that has the same denominators.
        void stepAsPlacesOf(const Edge &other) { m_places.rate = other.m_places.rate; }
        void stepAsColoursOf(const Edge &other)
        {
            for (std::size_t i = 0; i < 3; ++i)
                m_levels[i].rate = other.m_levels[i].rate;
        }
        void holdPlace() { m_places.rate = 0; }
        void holdColour()
        {
            for (Track &level : m_levels)
                level.rate = 0;
        }

        bool isBelow(const Edge &other) const
        {
            return m_places.at * other.m_places.denominator
                < other.m_places.at * m_places.denominator;
        }
        std::int64_t floor() const { return std::int64_t(m_places.floor()); }
        std::int64_t ceil() const { return std::int64_t(m_places.ceil()); }
        std::int64_t nearest() const
        {
            return std::int64_t(leftOf<Int128>(m_places.at, m_places.denominator, Kept::Nearest));
        }

    private:
        friend struct ExactWalk;

        /// What is stepped from a vertex on, in 1/256 px or of a level, and by how much it changes
        /// to the other vertex.
        struct Change {
            Int128 from, by;
            Kept kept; ///< of the quotient
        };
        /// At so many lattice units from the vertex. One along the spans stays at it.
        static Track trackOf(Change change, Lattice width, Lattice way)
        {
            if (width == 0)
                return {change.from, 0};
            Int128 divisor = width;
            if (width < 0) {
                divisor = -divisor;
                change.by = -change.by;
            }
            if (change.kept != Kept::All)
                change.by = leftOf<Int128>(change.by, divisor, change.kept) * divisor;
            return {change.from * divisor + way * change.by, change.by * unitsPerPixel,
                    divisor * unitsPerPixel};
        }

        const ProgramWalk &m_walk;
        Track m_places; ///< px
        std::array<Track, 3> m_levels;
    };
    using Bounds = WalkedBounds<Edge>;

    static const Edge &moved(const Edge &edge, double) { return edge; } // has no side

    static std::vector<WholeLevels> levelsOf(const Bounds &bounds, const WalkedSpan &span,
                                             const WalkedProgram &program)
    {
        const ProgramWalk &walk = program.walk();
        const std::array<Ramp, 3> ramps
            = {rampOf(bounds, span, program, 0), rampOf(bounds, span, program, 1),
               rampOf(bounds, span, program, 2)};
        std::vector<WholeLevels> levels(std::size_t(span.endDrawn - span.firstDrawn));
        for (std::size_t i = 0; i < 3; ++i) {
            Ramp ramp = ramps[i];
            if (walk.stepsAlongSpansOf[i] != i) // channels have one denominator
                ramp.step = ramps[walk.stepsAlongSpansOf[i]].step;
            store(ramp, span, program, levels, i);
        }
        return levels;
    }

private:
    /// A level along a span: at its first sample, and what is added to it.
    struct Ramp {
        Int256 first, step;
        Int256 denominator; ///< of both; > 0
    };

    /// y_T − y_B in fractions, or what is taken for it; its denominator is positive.
    static Int128 heightOf(const Track &lower, const Track &upper, const WalkedSpan &span,
                           SpanDivisor divisor)
    {
        const Int128 unit = lower.denominator * upper.denominator;
        const Int128 height = upper.at * lower.denominator - lower.at * upper.denominator;
        switch (divisor) {
        case SpanDivisor::Samples:
            return (span.end - span.first) * unit;
        case SpanDivisor::Steps:
            return (span.end - 1 - span.first) * unit;
        case SpanDivisor::HeightAndOne:
            return height + unit;
        case SpanDivisor::Height:
            break;
        }
        return height;
    }

    /// The way to the first sample over the lower bound's denominator.
    static Int128 preStepOf(const Track &lower, const WalkedSpan &span, PreStep preStep)
    {
        const Int128 toSample = span.first * lower.denominator - lower.at;
        switch (preStep) {
        case PreStep::ToSample:
        case PreStep::WithoutRate:
            return toSample;
        case PreStep::Backward:
            return -toSample;
        case PreStep::Fraction:
            return lower.at - lower.floor() * lower.denominator;
        case PreStep::None:
            break;
        }
        return 0;
    }

    /// All below 2^240.
    static Ramp rampOf(const Bounds &bounds, const WalkedSpan &span, const WalkedProgram &program,
                       std::size_t channel)
    {
        const ProgramWalk &walk = program.walk();
        const Track &lower = bounds.lower.m_places;
        const Track &upper = bounds.upper.m_places;
        Track atLower = bounds.lowerColours.m_levels[channel];
        Track atUpper = bounds.upperColours.m_levels[channel];
        atLower.store(walk.bounds);
        atUpper.store(walk.bounds);
        const bool isFromUpper = walk.spanColours == SpanColours::FromUpperBound;
        const Track &from = isFromUpper ? atUpper : atLower;
        const Track &other = isFromUpper ? atLower : atUpper;
        const Int128 height = heightOf(lower, upper, span, walk.divisor);
        if (height == 0) // nothing to share out
            return {from.at, 0, from.denominator};
        const Int256 unit = Int256(lower.denominator) * Int256(upper.denominator);
        const Int256 lift = atUpper.at * atLower.denominator - atLower.at * atUpper.denominator;
        const bool isNegative = (height < 0) != (walk.spanColours == SpanColours::Falling);
        const Int256 rise = isNegative ? Int256(-lift) : lift;
        const Int256 steepness = absolute(height);
        Ramp ramp{Int256(from.at) * Int256(other.denominator) * steepness, rise * unit,
                  Int256(atLower.denominator) * Int256(atUpper.denominator) * steepness};
        const PreStep preStep = program.spanPreStep();
        const Int256 way = preStepOf(lower, span, preStep);
        if (preStep == PreStep::WithoutRate)
            ramp = preSteppedBy(way, ramp, lower.denominator);
        else if (walk.preSteps == Kept::All)
            ramp.first += way * rise * Int256(upper.denominator);
        else
            ramp = preSteppedBy(leftOf(ramp.step, ramp.denominator, walk.preSteps) * way, ramp,
                                lower.denominator);
        if (walk.steps != Kept::All)
            ramp.step = leftOf(ramp.step, ramp.denominator, walk.steps) * ramp.denominator;
        if (walk.unsteppedAlongSpans.contains(channel))
            ramp.step = 0;
        if (walk.spanStepping == Stepping::BeforeDrawing)
            ramp.first += ramp.step;
        return ramp;
    }
    /// With something of another denominator added to its first sample.
    static Ramp preSteppedBy(const Int256 &added, const Ramp &ramp, const Int256 &denominator)
    {
        return {ramp.first * denominator + added * ramp.denominator, ramp.step * denominator,
                ramp.denominator * denominator};
    }

    static void store(const Ramp &ramp, const WalkedSpan &span, const WalkedProgram &program,
                      std::vector<WholeLevels> &levels, std::size_t channel)
    {
        const bool isNearest = program.rounding() == ByteRounding::Nearest;
        const Int256 skipped = span.firstDrawn - span.first;
        if (program.walk().levels != Kept::All)
            storeWhole(ramp, span, program.walk().levels, levels, channel);
        else if (isNearest) // ⌊v + ½⌋
            storeFloors({2 * (ramp.first + skipped * ramp.step) + ramp.denominator, 2 * ramp.step,
                         2 * ramp.denominator},
                        levels, channel);
        else
            storeFloors({ramp.first + skipped * ramp.step, ramp.step, ramp.denominator}, levels,
                        channel);
    }
    /// Quotients and remainders are stepped: nothing is divided from sample to sample.
    static void storeFloors(const Ramp &ramp, std::vector<WholeLevels> &levels, std::size_t channel)
    {
        const Int256 level = leftOf(ramp.first, ramp.denominator, Kept::Down);
        const Int256 step = leftOf(ramp.step, ramp.denominator, Kept::Down);
        Int256 rest = ramp.first - level * ramp.denominator;
        const Int256 restStep = ramp.step - step * ramp.denominator;
        auto whole = std::int64_t(level);
        const auto wholeStep = std::int64_t(step);
        for (WholeLevels &each : levels) {
            each[channel] = whole;
            whole += wholeStep;
            rest += restStep;
            if (rest >= ramp.denominator) {
                ++whole;
                rest -= ramp.denominator;
            }
        }
    }
    /// A channel whose level is a whole number at each sample.
    static void storeWhole(const Ramp &ramp, const WalkedSpan &span, Kept kept,
                           std::vector<WholeLevels> &levels, std::size_t channel)
    {
        auto level = std::int64_t(leftOf(ramp.first, ramp.denominator, kept));
        const auto down = std::int64_t(leftOf(ramp.step, ramp.denominator, Kept::Down));
        const auto nearest = std::int64_t(leftOf(ramp.step, ramp.denominator, Kept::Nearest));
        const bool isWhole = ramp.step % ramp.denominator == 0;
        for (std::int64_t place = span.first; place < span.endDrawn; ++place) {
            if (place >= span.firstDrawn)
                levels[std::size_t(place - span.firstDrawn)][channel] = level;
            // A whole number and a step between two: below 0 it is cut upward.
            const bool isCutUpward = kept == Kept::TowardZero && level + down < 0 && !isWhole;
            level += kept == Kept::Nearest ? nearest : down + (isCutUpward ? 1 : 0);
        }
    }
};

} // namespace pixelplumb
