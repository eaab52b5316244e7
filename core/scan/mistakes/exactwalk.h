// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/exactedge.h"
#include "core/scan/mistakes/exactramp.h"
#include "core/scan/mistakes/walkedprogram.h"

#include <algorithm>
#include <optional>

namespace pixelplumb {

/// A program's walk in fractions. For coordinates up to 2^15 px an edge's denominator, ΔX·S, stays
/// below 2^33, or below 2^66 where it continues another's end; numerators stay below 2^90.
struct ExactWalk {
    static bool represents(const LatticePoint &point) { return isNarrow(point); }

    using Number = MixedNumber<Int128>;
    using Track = ExactTrack;
    using Edge = ExactEdge;
    using Bounds = WalkedBounds<Edge>;

    static const Edge &moved(const Edge &edge, double) { return edge; } // exact: no rounding side

    /// R G B just after a span's last sample, in 1/2^32.
    using Carried = std::array<Int256, 3>;

    /// Half of the width suffices for most frames and is much faster.
    static void fill(SpanLevels<Number> &levels, const Bounds &bounds, const WalkedSpan &span,
                     const WalkedProgram &program, std::optional<Carried> &carried)
    {
        if (isHeldByHalf(bounds, span, program))
            fillIn<Int128>(levels, bounds, span, program, carried);
        else
            fillIn<Int256>(levels, bounds, span, program, carried);
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
        const ScanBugs &bugs = program.bugs();
        if (bugs.spanStart != SpanStart::AtBound)
            return false;
        Int128 denominator = 1;
        Int128 numerator = 1;
        const auto see = [&](const Track &track) {
            denominator = std::max(denominator, track.denominator);
            numerator = std::max(numerator, absolute(track.at));
        };
        for (const Edge *edge : {&bounds.lower, &bounds.upper})
            see(edge->track());
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
            = bugs.spanPreStep != PreStep::WithoutRate && bugs.preSteps == Truncation::All;
        return numerator < half && numerator * denominator < Int128(1) << (isPlain ? 58 : 46);
    }

    template <class Integer>
    static void fillIn(SpanLevels<Number> &levels, const Bounds &bounds, const WalkedSpan &span,
                       const WalkedProgram &program, std::optional<Carried> &carried)
    {
        const ScanBugs &bugs = program.bugs();
        const std::array<ExactRamp<Integer>, 3> ramps
            = {rampOf<Integer>(bounds, span, program, 0, carried),
               rampOf<Integer>(bounds, span, program, 1, carried),
               rampOf<Integer>(bounds, span, program, 2, carried)};
        Carried behind;
        for (std::size_t i = 0; i < 3; ++i) {
            ExactRamp<Integer> ramp = ramps[i];
            if (sourceOf(i, bugs.stepsAlongSpansOf) != i) // channels share a denominator
                ramp.step = ramps[sourceOf(i, bugs.stepsAlongSpansOf)].step;
            levels.step[i] = mixedNumber(ramp.step, ramp.denominator);
            levels.first[i] = mixedNumber<Integer>(
                ramp.first + Integer(span.firstDrawn - span.first) * ramp.step, ramp.denominator);
            if (bugs.spanStoring == Storing::FirstAlone) {
                ramp.first
                    = leftOf<Integer>(ramp.first, ramp.denominator, bugs.levels) * ramp.denominator;
            } else if (bugs.levels != Truncation::All) {
                behind[i] = storeWhole(ramp, span, program, levels.whole, i) * carriedUnit;
                for (std::size_t k = 0; k < levels.own.size(); ++k)
                    levels.own[k][i] = Number::fromWhole(levels.whole[k][i]);
                continue;
            }
            store(ramp, span, program, levels.whole, i);
            for (std::size_t k = 0; k < levels.own.size(); ++k)
                levels.own[k][i] = mixedNumber<Integer>(
                    ramp.first
                        + Integer(span.firstDrawn - span.first + std::int64_t(k)) * ramp.step,
                    ramp.denominator);
            if (bugs.spanStart != SpanStart::AtBound)
                behind[i] = leftOf<Int256>((Int256(ramp.first) + span.samples() * Int256(ramp.step))
                                               * carriedUnit,
                                           Int256(ramp.denominator), Truncation::Nearest);
        }
        if (bugs.spanStart != SpanStart::AtBound)
            carried = behind;
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
        const ScanBugs &bugs = program.bugs();
        const Track &lower = bounds.lower.track();
        const Track &upper = bounds.upper.track();
        const Track atLower = levelAt(bounds.lowerColours, channel, bugs.bounds);
        const Track atUpper = levelAt(bounds.upperColours, channel, bugs.bounds);
        if (bugs.spanColours == SpanColours::Mean)
            return {Integer(atLower.at * atUpper.denominator + atUpper.at * atLower.denominator), 0,
                    Integer(2 * atLower.denominator * atUpper.denominator)};
        const bool isFromUpper = bugs.spanColours == SpanColours::FromUpperBound
            || bugs.spanColours == SpanColours::UpperAlone;
        const Track &from = isFromUpper ? atUpper : atLower;
        const Track &other = isFromUpper ? atLower : atUpper;
        const Int128 height = heightOf(lower, upper, span, bugs.divisor);
        if (height == 0 || isFlat(bugs.spanColours)) // nothing to distribute
            return {from.at, 0, from.denominator};
        const std::size_t source = sourceOf(channel, bugs.ratesAlongSpansOf);
        const Integer unit = Integer(lower.denominator) * Integer(upper.denominator);
        const Integer lift
            = levelAt(bounds.upperColours, source, bugs.bounds).at * atLower.denominator
            - levelAt(bounds.lowerColours, source, bugs.bounds).at * atUpper.denominator;
        const bool isNegative = (height < 0) != (bugs.spanColours == SpanColours::Falling);
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
        const ScanBugs &bugs = program.bugs();
        ExactRamp<Integer> ramp = rampAtBound<Integer>(bounds, span, program, channel);
        ramp = carried ? ExactRamp<Integer>{Integer((*carried)[channel]) * ramp.denominator,
                                            ramp.step * carriedUnit, ramp.denominator * carriedUnit}
                       : preStepped(ramp, bounds.lower.track(), span, program, channel);
        if (bugs.steps != Truncation::All)
            ramp.step = leftOf<Integer>(ramp.step, ramp.denominator, bugs.steps) * ramp.denominator;
        if (bugs.unsteppedAlongSpans.contains(channel))
            ramp.step = 0;
        if (bugs.spanStepping == Stepping::BeforeDrawing)
            ramp.first += ramp.step;
        return ramp;
    }

    template <class Integer>
    static ExactRamp<Integer> preStepped(ExactRamp<Integer> ramp, const Track &lower,
                                         const WalkedSpan &span, const WalkedProgram &program,
                                         std::size_t channel)
    {
        const ScanBugs &bugs = program.bugs();
        const PreStep preStep = bugs.spanPreStep;
        const bool isLeftOut = bugs.withoutSpanPreStep.contains(channel);
        const Integer way = isLeftOut ? Int128(0) : preStepOf(lower, span, preStep);
        const Integer denominator = lower.denominator;
        if (preStep == PreStep::WithoutRate)
            return ramp.preSteppedBy(way, denominator);
        if (bugs.preSteps != Truncation::All)
            return ramp.preSteppedBy(
                leftOf<Integer>(ramp.step, ramp.denominator, bugs.preSteps) * way, denominator);
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
        const Truncation kept = program.bugs().levels;
        auto level = std::int64_t(leftOf<Integer>(ramp.first, ramp.denominator, kept));
        std::optional<std::int64_t> second;
        if (program.bugs().spanStoring == Storing::BehindSteps) {
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
