// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/exactedge.h"
#include "core/grade/walkedprogram.h"
#include "core/number/wideinteger.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

/// A program's walk in fractions. Of coordinates up to 2^15 px an edge's denominator, ΔX·S, stays
/// below 2^33 and, where it is carried on from another's end, below 2^66; numerators below 2^90.
struct ExactWalk {
    static bool represents(const LatticePoint &point) { return isNarrow(point); }

    using Track = ExactTrack;
    using Edge = ExactEdge;
    using Bounds = WalkedBounds<Edge>;

    static const Edge &moved(const Edge &edge, double) { return edge; } // has no side

    /// What R G B have come to behind the last sample of a span, in 1/2^32.
    using Carried = std::array<Int256, 3>;

    static std::vector<WholeLevels> levelsOf(const Bounds &bounds, const WalkedSpan &span,
                                             const WalkedProgram &program,
                                             std::optional<Carried> &carried)
    {
        const ProgramWalk &walk = program.walk();
        const std::array<Ramp, 3> ramps
            = {rampOf(bounds, span, program, 0, carried), rampOf(bounds, span, program, 1, carried),
               rampOf(bounds, span, program, 2, carried)};
        std::vector<WholeLevels> levels(span.drawn());
        Carried behind;
        for (std::size_t i = 0; i < 3; ++i) {
            Ramp ramp = ramps[i];
            if (walk.stepsAlongSpansOf[i] != i) // channels have one denominator
                ramp.step = ramps[walk.stepsAlongSpansOf[i]].step;
            if (walk.spanStoring == Storing::FirstAlone) {
                ramp.first = leftOf(ramp.first, ramp.denominator, walk.levels) * ramp.denominator;
            } else if (walk.levels != Kept::All) {
                behind[i] = storeWhole(ramp, span, program, levels, i) * carriedUnit;
                continue;
            }
            store(ramp, span, program, levels, i);
            if (walk.spanStart != SpanStart::AtBound)
                behind[i] = leftOf<Int256>((ramp.first + span.samples() * ramp.step) * carriedUnit,
                                           ramp.denominator, Kept::Nearest);
        }
        if (walk.spanStart != SpanStart::AtBound)
            carried = behind;
        return levels;
    }

private:
    static constexpr std::int64_t carriedUnit = std::int64_t(1) << 32;

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
        case SpanDivisor::HeightLessOne:
            return height - unit;
        case SpanDivisor::HeightFromOne:
            return height < unit ? Int128(0) : height;
        case SpanDivisor::HeightOfFloors:
            return (upper.floor() - lower.floor()) * unit;
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

    static Track levelAt(const Edge &edge, std::size_t channel, Kept kept)
    {
        Track level = edge.level(channel);
        level.store(kept);
        return level;
    }

    /// With R of the bound at the first sample. All below 2^240.
    static Ramp rampAtBound(const Bounds &bounds, const WalkedSpan &span,
                            const WalkedProgram &program, std::size_t channel)
    {
        const ProgramWalk &walk = program.walk();
        const Track &lower = bounds.lower.place();
        const Track &upper = bounds.upper.place();
        const Track atLower = levelAt(bounds.lowerColours, channel, walk.bounds);
        const Track atUpper = levelAt(bounds.upperColours, channel, walk.bounds);
        if (walk.spanColours == SpanColours::Mean)
            return {Int256(atLower.at * atUpper.denominator + atUpper.at * atLower.denominator), 0,
                    Int256(2 * atLower.denominator * atUpper.denominator)};
        const bool isFromUpper = walk.spanColours == SpanColours::FromUpperBound
            || walk.spanColours == SpanColours::UpperAlone;
        const Track &from = isFromUpper ? atUpper : atLower;
        const Track &other = isFromUpper ? atLower : atUpper;
        const Int128 height = heightOf(lower, upper, span, walk.divisor);
        if (height == 0 || isFlat(walk.spanColours)) // nothing to share out
            return {from.at, 0, from.denominator};
        const std::size_t source = walk.ratesAlongSpansOf[channel];
        const Int256 unit = Int256(lower.denominator) * Int256(upper.denominator);
        const Int256 lift
            = levelAt(bounds.upperColours, source, walk.bounds).at * atLower.denominator
            - levelAt(bounds.lowerColours, source, walk.bounds).at * atUpper.denominator;
        const bool isNegative = (height < 0) != (walk.spanColours == SpanColours::Falling);
        const Int256 steepness = absolute(height);
        return {Int256(from.at) * Int256(other.denominator) * steepness,
                (isNegative ? Int256(-lift) : lift) * unit,
                Int256(atLower.denominator) * Int256(atUpper.denominator) * steepness};
    }

    static Ramp rampOf(const Bounds &bounds, const WalkedSpan &span, const WalkedProgram &program,
                       std::size_t channel, const std::optional<Carried> &carried)
    {
        const ProgramWalk &walk = program.walk();
        Ramp ramp = rampAtBound(bounds, span, program, channel);
        ramp = carried ? Ramp{(*carried)[channel] * ramp.denominator, ramp.step * carriedUnit,
                              ramp.denominator * carriedUnit}
                       : preStepped(ramp, bounds.lower.place(), span, program, channel);
        if (walk.steps != Kept::All)
            ramp.step = leftOf(ramp.step, ramp.denominator, walk.steps) * ramp.denominator;
        if (walk.unsteppedAlongSpans.contains(channel))
            ramp.step = 0;
        if (walk.spanStepping == Stepping::BeforeDrawing)
            ramp.first += ramp.step;
        return ramp;
    }

    static Ramp preStepped(Ramp ramp, const Track &lower, const WalkedSpan &span,
                           const WalkedProgram &program, std::size_t channel)
    {
        const ProgramWalk &walk = program.walk();
        const PreStep preStep = program.spanPreStep();
        const bool isLeftOut = walk.withoutSpanPreStep.contains(channel);
        const Int256 way = isLeftOut ? Int128(0) : preStepOf(lower, span, preStep);
        if (preStep == PreStep::WithoutRate)
            return preSteppedBy(way, ramp, lower.denominator);
        if (walk.preSteps != Kept::All)
            return preSteppedBy(leftOf(ramp.step, ramp.denominator, walk.preSteps) * way, ramp,
                                lower.denominator);
        ramp.first += way * (ramp.step / lower.denominator); // a multiple of it
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
        if (isNearest) // ⌊v + ½⌋
            storeFloors({2 * (ramp.first + skipped * ramp.step) + ramp.denominator, 2 * ramp.step,
                         2 * ramp.denominator},
                        levels, channel);
        else
            storeFloors({ramp.first + skipped * ramp.step, ramp.step, ramp.denominator}, levels,
                        channel);
    }
    /// What most frames need is stepped in half of the width, which takes a fraction of the time.
    static void storeFloors(const Ramp &ramp, std::vector<WholeLevels> &levels, std::size_t channel)
    {
        static const Int256 narrow = Int256(1) << 125;
        const bool isNarrow = absolute(ramp.first) < narrow && absolute(ramp.step) < narrow
            && ramp.denominator < narrow;
        if (isNarrow)
            storeFloorsIn(Int128(ramp.first), Int128(ramp.step), Int128(ramp.denominator), levels,
                          channel);
        else
            storeFloorsIn(ramp.first, ramp.step, ramp.denominator, levels, channel);
    }
    /// Quotients and remainders are stepped: nothing is divided from sample to sample.
    template <class Integer>
    static void storeFloorsIn(const Integer &first, const Integer &step, const Integer &denominator,
                              std::vector<WholeLevels> &levels, std::size_t channel)
    {
        const Integer level = leftOf<Integer>(first, denominator, Kept::Down);
        const Integer levelStep = leftOf<Integer>(step, denominator, Kept::Down);
        Integer rest = first - level * denominator;
        const Integer restStep = step - levelStep * denominator;
        auto whole = std::int64_t(level);
        const auto wholeStep = std::int64_t(levelStep);
        for (WholeLevels &each : levels) {
            each[channel] = whole;
            whole += wholeStep;
            rest += restStep;
            if (rest >= denominator) {
                ++whole;
                rest -= denominator;
            }
        }
    }
    /// A channel whose level is a whole number at each sample, or at all but the first; gives what
    /// it has come to behind the last one.
    static std::int64_t storeWhole(const Ramp &ramp, const WalkedSpan &span,
                                   const WalkedProgram &program, std::vector<WholeLevels> &levels,
                                   std::size_t channel)
    {
        const Kept kept = program.walk().levels;
        auto level = std::int64_t(leftOf(ramp.first, ramp.denominator, kept));
        std::optional<std::int64_t> second;
        if (program.walk().spanStoring == Storing::BehindSteps) {
            const bool isNearest = program.rounding() == ByteRounding::Nearest;
            level = std::int64_t(
                leftOf(ramp.first, ramp.denominator, isNearest ? Kept::Nearest : Kept::Down));
            second = std::int64_t(leftOf<Int256>(ramp.first + ramp.step, ramp.denominator, kept));
        }
        const auto down = std::int64_t(leftOf(ramp.step, ramp.denominator, Kept::Down));
        const auto nearest = std::int64_t(leftOf(ramp.step, ramp.denominator, Kept::Nearest));
        const bool isWhole = ramp.step % ramp.denominator == 0;
        for (std::int64_t place = span.first; place < span.end; ++place) {
            if (place >= span.firstDrawn && place < span.endDrawn)
                levels[std::size_t(place - span.firstDrawn)][channel] = level;
            if (place == span.first && second) {
                level = *second;
                continue;
            }
            // A whole number and a step between two: below 0 it is cut upward.
            const bool isCutUpward = kept == Kept::TowardZero && level + down < 0 && !isWhole;
            level += kept == Kept::Nearest ? nearest : down + (isCutUpward ? 1 : 0);
        }
        return level;
    }
};

} // namespace pixelplumb
