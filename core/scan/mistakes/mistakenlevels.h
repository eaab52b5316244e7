// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/mistakes/fractionwalk.h"
#include "core/scan/mistakes/walkedprogram.h"

/// A channel's levels along a span of a mistaken scan.
namespace pixelplumb {

/// A level along a span: at one sample, its step, its possible error, and at the bound.
template <class Value>
struct LevelRamp {
    Value level, step, error, from;
};

/// Whether a whole number is added to the bound's level at each sample.
inline bool isOfSums(const ScanBugs &bugs)
{
    return isOfAdded(bugs.spanStoring) && bugs.levels != Truncation::All;
}

/// What is kept of a level at each step.
inline Truncation keptAtSteps(const ScanBugs &bugs)
{
    return bugs.spanStoring == Storing::FirstAlone || isOfSums(bugs) ? Truncation::All
                                                                     : bugs.levels;
}

/// One past the last sample whose level is computed: spans that go on need them all.
inline std::int64_t endOfLevels(const WalkedSpan &span, const ScanBugs &bugs)
{
    return bugs.spanStart == SpanStart::AtBound ? span.endDrawn : span.end;
}

/// Of fractions of which a whole number is kept at each step: only the first is none.
inline Fraction storeWholeLevels(const LevelRamp<Fraction> &ramp, std::int64_t reached,
                                 const WalkedSpan &span, const WalkedProgram &program,
                                 SpanLevels<Fraction> &levels, std::size_t channel)
{
    const ScanBugs &bugs = program.bugs();
    const std::int64_t end = endOfLevels(span, bugs);
    levels.first[channel] = ramp.level;
    if (reached >= end)
        return ramp.level;
    const auto store = [&](std::int64_t place, std::int64_t whole) {
        if (place < span.firstDrawn || place >= span.endDrawn)
            return;
        const auto sample = std::size_t(place - span.firstDrawn);
        levels.whole[sample][channel] = whole;
        if (levels.hasNumbers)
            levels.own[sample][channel] = whole;
    };
    store(reached, wholeLevel(ramp.level, program.rounding()));
    if (levels.hasNumbers && reached == span.firstDrawn && !levels.own.empty())
        levels.own.front()[channel] = ramp.level;
    const WholeSteps steps(ramp.step, bugs.levels);
    Int128 whole = leftOf(ramp.level + ramp.step, bugs.levels).floor();
    for (std::int64_t place = reached + 1; place < end; ++place) {
        if (place == span.firstDrawn)
            levels.first[channel] = Fraction(whole, 1);
        store(place, std::int64_t(whole));
        whole = steps.after(whole);
    }
    return {whole, 1};
}

/// Of fractions, which are not stepped from sample to sample: their floors are, or the whole
/// numbers that are kept.
inline Fraction storeLevels(const LevelRamp<Fraction> &ramp, std::int64_t reached,
                            const WalkedSpan &span, const WalkedProgram &program,
                            SpanLevels<Fraction> &levels, std::size_t channel)
{
    const ScanBugs &bugs = program.bugs();
    levels.step[channel] = ramp.step;
    if (keptAtSteps(bugs) != Truncation::All)
        return storeWholeLevels(ramp, reached, span, program, levels, channel);
    const auto levelAt = [&](std::int64_t place) {
        return place == reached ? ramp.level : ramp.level + Fraction(place - reached) * ramp.step;
    };
    const Fraction first = levelAt(span.firstDrawn);
    levels.first[channel] = first;
    const std::size_t samples = levels.whole.size();
    if (isOfSums(bugs)) {
        const std::int64_t from = wholeLevel(ramp.from, program.rounding());
        storeWhole(first - ramp.from, ramp.step, bugs.levels, samples,
                   [&](std::size_t sample, std::int64_t added) {
                       levels.whole[sample][channel] = from + added;
                       if (levels.hasNumbers)
                           levels.own[sample][channel] = ramp.from + Fraction(added);
                   });
    } else {
        const bool isNearest = program.rounding() == ByteRounding::Nearest;
        storeFloors(
            isNearest ? first + Fraction(1, 2) : first, ramp.step, samples,
            [&](std::size_t sample, std::int64_t whole) { levels.whole[sample][channel] = whole; });
        Fraction own = first;
        for (auto &sample : levels.own) {
            sample[channel] = own;
            own = own + ramp.step;
        }
    }
    return bugs.spanStart == SpanStart::AtBound ? first : levelAt(span.end);
}

/// Stores the levels of a span, as the program steps them from the sample `reached` on; returns the
/// level just after its last sample, or any where spans do not go on.
template <class Value>
Value storeLevels(const LevelRamp<Value> &ramp, std::int64_t reached, const WalkedSpan &span,
                  const WalkedProgram &program, SpanLevels<Value> &levels, std::size_t channel)
{
    using Traits = NumberTraits<Value>;
    const ScanBugs &bugs = program.bugs();
    const bool isOfSum = isOfSums(bugs);
    const Truncation kept = keptAtSteps(bugs);
    Value level = ramp.level;
    std::int64_t place = reached;
    const bool goesOn = bugs.spanStart != SpanStart::AtBound;
    if (kept == Truncation::All && !goesOn && reached != span.firstDrawn) {
        level = level + Traits::fromInteger(span.firstDrawn - reached) * ramp.step;
        place = span.firstDrawn;
    }
    levels.first[channel] = level;
    levels.step[channel] = ramp.step;
    for (; place < endOfLevels(span, bugs); ++place) {
        if (place == span.firstDrawn)
            levels.first[channel] = level;
        if (place >= span.firstDrawn && place < span.endDrawn) {
            const auto sample = std::size_t(place - span.firstDrawn);
            const Value drawn
                = isOfSum ? ramp.from + leftOf(level - ramp.from, bugs.levels) : level;
            levels.whole[sample][channel] = wholeLevel(
                std::is_same_v<Value, double> ? drawn + ramp.error : drawn, program.rounding());
            if (levels.hasNumbers)
                levels.own[sample][channel] = drawn;
        }
        stepBy(level, ramp.step);
        if (kept != Truncation::All)
            level = leftOf(level, kept);
    }
    return level;
}

} // namespace pixelplumb
