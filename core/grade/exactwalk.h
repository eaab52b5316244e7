// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/exactedge.h"
#include "core/grade/exactramp.h"
#include "core/grade/walkedprogram.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

/// A program's walk in fractions. For coordinates up to 2^15 px an edge's denominator, ΔX·S, stays
/// below 2^33, or below 2^66 where it continues another's end; numerators stay below 2^90.
struct ExactWalk {
    static bool represents(const LatticePoint &point) { return isNarrow(point); }

    using Track = ExactTrack;
    using Edge = ExactEdge;
    using Bounds = WalkedBounds<Edge>;

    static const Edge &moved(const Edge &edge, double) { return edge; } // exact: no rounding side

    /// R G B just after a span's last sample, in 1/2^32.
    using Carried = std::array<Int256, 3>;

    /// Half of the width suffices for most frames and is much faster.
    static std::vector<WholeLevels> levelsOf(const Bounds &bounds, const WalkedSpan &span,
                                             const WalkedProgram &program,
                                             std::optional<Carried> &carried)
    {
        return isHeldByHalf(bounds, span, program)
            ? levelsIn<Int128>(bounds, span, program, carried)
            : levelsIn<Int256>(bounds, span, program, carried);
    }

private:
    static constexpr std::int64_t carriedUnit = std::int64_t(1) << 32;

    /// Whether half of the width holds the ramps. With numerators below 2^n, denominators below 2^d
    /// < 2^n and places below 2^(n − d), a ramp's first level is at most 2^(2n + 2d + 6), with d
    /// bits more where its pre-step is a separate fraction. A product below 2^58 means n + d < 60,
    /// one below 2^46 means d < 24.
    static bool isHeldByHalf(const Bounds &bounds, const WalkedSpan &span,
                             const WalkedProgram &program)
    {
        const ProgramWalk &walk = program.walk();
        if (walk.spanStart != SpanStart::AtBound)
            return false;
        Int128 denominator = 1;
        Int128 numerator = 1;
        const auto see = [&](const Track &track) {
            denominator = std::max(denominator, track.denominator);
            numerator = std::max(numerator, absolute(track.at));
        };
        for (const Edge *edge : {&bounds.lower, &bounds.upper})
            see(edge->place());
        for (const Edge *edge : {&bounds.lowerColours, &bounds.upperColours}) {
            for (std::size_t i = 0; i < 3; ++i)
                see(edge->level(i));
        }
        const Int128 farthest
            = std::max({absolute(span.first), absolute(span.end), absolute(span.firstDrawn)}) + 1;
        constexpr Int128 half = Int128(1) << 62;
        if (denominator >= half || numerator >= half || farthest >= half)
            return false;
        numerator = std::max(numerator, denominator * farthest);
        const bool isPlain
            = program.spanPreStep() != PreStep::WithoutRate && walk.preSteps == Truncation::All;
        return numerator < half && numerator * denominator < Int128(1) << (isPlain ? 58 : 46);
    }

    template <class Integer>
    static std::vector<WholeLevels> levelsIn(const Bounds &bounds, const WalkedSpan &span,
                                             const WalkedProgram &program,
                                             std::optional<Carried> &carried)
    {
        const ProgramWalk &walk = program.walk();
        const std::array<ExactRamp<Integer>, 3> ramps
            = {rampOf<Integer>(bounds, span, program, 0, carried),
               rampOf<Integer>(bounds, span, program, 1, carried),
               rampOf<Integer>(bounds, span, program, 2, carried)};
        std::vector<WholeLevels> levels(span.drawn());
        Carried behind;
        for (std::size_t i = 0; i < 3; ++i) {
            ExactRamp<Integer> ramp = ramps[i];
            if (walk.stepsAlongSpansOf[i] != i) // channels share a denominator
                ramp.step = ramps[walk.stepsAlongSpansOf[i]].step;
            if (walk.spanStoring == Storing::FirstAlone) {
                ramp.first
                    = leftOf<Integer>(ramp.first, ramp.denominator, walk.levels) * ramp.denominator;
            } else if (walk.levels != Truncation::All) {
                behind[i] = storeWhole(ramp, span, program, levels, i) * carriedUnit;
                continue;
            }
            store(ramp, span, program, levels, i);
            if (walk.spanStart != SpanStart::AtBound)
                behind[i] = leftOf<Int256>((Int256(ramp.first) + span.samples() * Int256(ramp.step))
                                               * carriedUnit,
                                           Int256(ramp.denominator), Truncation::Nearest);
        }
        if (walk.spanStart != SpanStart::AtBound)
            carried = behind;
        return levels;
    }

    /// y_T − y_B in fractions, or what replaces it; the denominator is positive.
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

    /// The distance to the first sample, over the lower bound's denominator.
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

    static Track levelAt(const Edge &edge, std::size_t channel, Truncation kept)
    {
        Track level = edge.level(channel);
        level.store(kept);
        return level;
    }

    /// The ramp with the bound's R at the first sample. All numbers stay below 2^240.
    template <class Integer>
    static ExactRamp<Integer> rampAtBound(const Bounds &bounds, const WalkedSpan &span,
                                          const WalkedProgram &program, std::size_t channel)
    {
        const ProgramWalk &walk = program.walk();
        const Track &lower = bounds.lower.place();
        const Track &upper = bounds.upper.place();
        const Track atLower = levelAt(bounds.lowerColours, channel, walk.bounds);
        const Track atUpper = levelAt(bounds.upperColours, channel, walk.bounds);
        if (walk.spanColours == SpanColours::Mean)
            return {Integer(atLower.at * atUpper.denominator + atUpper.at * atLower.denominator), 0,
                    Integer(2 * atLower.denominator * atUpper.denominator)};
        const bool isFromUpper = walk.spanColours == SpanColours::FromUpperBound
            || walk.spanColours == SpanColours::UpperAlone;
        const Track &from = isFromUpper ? atUpper : atLower;
        const Track &other = isFromUpper ? atLower : atUpper;
        const Int128 height = heightOf(lower, upper, span, walk.divisor);
        if (height == 0 || isFlat(walk.spanColours)) // nothing to distribute
            return {from.at, 0, from.denominator};
        const std::size_t source = walk.ratesAlongSpansOf[channel];
        const Integer unit = Integer(lower.denominator) * Integer(upper.denominator);
        const Integer lift
            = levelAt(bounds.upperColours, source, walk.bounds).at * atLower.denominator
            - levelAt(bounds.lowerColours, source, walk.bounds).at * atUpper.denominator;
        const bool isNegative = (height < 0) != (walk.spanColours == SpanColours::Falling);
        const Integer steepness = absolute(height);
        return {Integer(from.at) * Integer(other.denominator) * steepness,
                (isNegative ? Integer(-lift) : lift) * unit,
                Integer(atLower.denominator) * Integer(atUpper.denominator) * steepness};
    }

    template <class Integer>
    static ExactRamp<Integer> rampOf(const Bounds &bounds, const WalkedSpan &span,
                                     const WalkedProgram &program, std::size_t channel,
                                     const std::optional<Carried> &carried)
    {
        const ProgramWalk &walk = program.walk();
        ExactRamp<Integer> ramp = rampAtBound<Integer>(bounds, span, program, channel);
        ramp = carried ? ExactRamp<Integer>{Integer((*carried)[channel]) * ramp.denominator,
                                            ramp.step * carriedUnit, ramp.denominator * carriedUnit}
                       : preStepped(ramp, bounds.lower.place(), span, program, channel);
        if (walk.steps != Truncation::All)
            ramp.step = leftOf<Integer>(ramp.step, ramp.denominator, walk.steps) * ramp.denominator;
        if (walk.unsteppedAlongSpans.contains(channel))
            ramp.step = 0;
        if (walk.spanStepping == Stepping::BeforeDrawing)
            ramp.first += ramp.step;
        return ramp;
    }

    template <class Integer>
    static ExactRamp<Integer> preStepped(ExactRamp<Integer> ramp, const Track &lower,
                                         const WalkedSpan &span, const WalkedProgram &program,
                                         std::size_t channel)
    {
        const ProgramWalk &walk = program.walk();
        const PreStep preStep = program.spanPreStep();
        const bool isLeftOut = walk.withoutSpanPreStep.contains(channel);
        const Integer way = isLeftOut ? Int128(0) : preStepOf(lower, span, preStep);
        const Integer denominator = lower.denominator;
        if (preStep == PreStep::WithoutRate)
            return ramp.preSteppedBy(way, denominator);
        if (walk.preSteps != Truncation::All)
            return ramp.preSteppedBy(
                leftOf<Integer>(ramp.step, ramp.denominator, walk.preSteps) * way, denominator);
        ramp.first += way * (ramp.step / denominator); // step is a multiple of it
        return ramp;
    }
    template <class Integer>
    static void store(const ExactRamp<Integer> &ramp, const WalkedSpan &span,
                      const WalkedProgram &program, std::vector<WholeLevels> &levels,
                      std::size_t channel)
    {
        const bool isNearest = program.rounding() == ByteRounding::Nearest;
        const Integer skipped = span.firstDrawn - span.first;
        const Integer first = ramp.first + skipped * ramp.step;
        const ExactRamp<Integer> stored = isNearest // ⌊v + ½⌋
            ? ExactRamp<Integer>{2 * first + ramp.denominator, 2 * ramp.step, 2 * ramp.denominator}
            : ExactRamp<Integer>{first, ramp.step, ramp.denominator};
        stored.storeFloors(levels, channel);
    }
    /// Stores a channel whose level is a whole number at each sample, or at all but the first;
    /// returns the level just after the last one.
    template <class Integer>
    static std::int64_t storeWhole(const ExactRamp<Integer> &ramp, const WalkedSpan &span,
                                   const WalkedProgram &program, std::vector<WholeLevels> &levels,
                                   std::size_t channel)
    {
        const Truncation kept = program.walk().levels;
        auto level = std::int64_t(leftOf<Integer>(ramp.first, ramp.denominator, kept));
        std::optional<std::int64_t> second;
        if (program.walk().spanStoring == Storing::BehindSteps) {
            const bool isNearest = program.rounding() == ByteRounding::Nearest;
            level = std::int64_t(leftOf<Integer>(
                ramp.first, ramp.denominator, isNearest ? Truncation::Nearest : Truncation::Down));
            second = std::int64_t(leftOf<Integer>(ramp.first + ramp.step, ramp.denominator, kept));
        }
        const auto down
            = std::int64_t(leftOf<Integer>(ramp.step, ramp.denominator, Truncation::Down));
        const auto nearest
            = std::int64_t(leftOf<Integer>(ramp.step, ramp.denominator, Truncation::Nearest));
        const bool isWhole = ramp.step % ramp.denominator == 0;
        for (std::int64_t place = span.first; place < span.end; ++place) {
            if (place >= span.firstDrawn && place < span.endDrawn)
                levels[std::size_t(place - span.firstDrawn)][channel] = level;
            if (place == span.first && second) {
                level = *second;
                continue;
            }
            // A fractional step is added to a whole number: below 0 truncation goes upward.
            const bool isCutUpward = kept == Truncation::TowardZero && level + down < 0 && !isWhole;
            level += kept == Truncation::Nearest ? nearest : down + (isCutUpward ? 1 : 0);
        }
        return level;
    }
};

} // namespace pixelplumb
