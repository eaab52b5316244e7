// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/curvewords.h"
#include "core/scan/curves/flatpixel.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How single-colour pixels become records. The tables of these methods read the kernels' own
/// numbers, unless a recording has another stateOf().
struct FlatRecording {
    template <class SetUp>
    static const SetUp &stateOf(const CurrentSetUp<SetUp> &step)
    {
        return step.setUp;
    }
    template <class SetUp, class Span>
    static const Span &stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return step.span;
    }
    template <class SetUp, class Span>
    static const FlatSample &stateOf(const CurrentSample<SetUp, Span, FlatSample> &step)
    {
        return step.sample;
    }

    /// All numbers of a step are in its span.
    static const NumberTable<FlatSample> &sampleNumbers()
    {
        static const NumberTable<FlatSample> none;
        return none;
    }

    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellCurve(words, state))
    {
        tellCurve(words, state);
    }

    static bool isClamped(const FlatSample &) { return false; }

    template <class SetUp>
    static void record(const SetUp &, SetUpRecord &)
    {
    }
    template <class Span>
    static void record(const Span &, SpanRecord &)
    {
    }
    static void record(const FlatSample &sample, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            record.level[channel] = sample.colour.channels[channel];
            record.colour[channel] = Quantity::integer(sample.colour.channels[channel]);
        }
    }

protected:
    static SpanPlace freeStep(std::int64_t number, int part = 0)
    {
        return {SpanAxis::Free, number, part};
    }
};

} // namespace pixelplumb
