// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/strokenumbers.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of strokes become records. A pixel depends on what it held, so columns cannot be
/// walked again: samples are kept.
struct StrokeRecording : StrokeNumbers {
    static const auto &setUpNumbers(Antialiasing = Antialiasing::Area)
    {
        return strokeSetUpNumbers();
    }
    static const auto &spanNumbers(Antialiasing = Antialiasing::Area)
    {
        return strokeColumnNumbers();
    }
    static auto sampleNumbers(Antialiasing antialiasing = Antialiasing::Area)
    {
        return strokeSampleNumbers(antialiasing);
    }

    static const SetUp &stateOf(const CurrentSetUp<SetUp> &step) { return step.setUp; }
    static const Span &stateOf(const CurrentSpan<SetUp, Span> &step) { return step.span; }
    static StrokeSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return {step.setUp, step.sample, step.settings.rounding,
                step.x,     step.y,      step.fate == SampleFate::Refused};
    }
    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellStroke(words, state))
    {
        tellStroke(words, state);
    }

    static SpanPlace placeOf(const Span &column) { return {SpanAxis::Column, column.x, 0}; }
    static bool isClamped(const Sample &) { return false; }

    static void record(const SetUp &, SetUpRecord &) { }
    static void record(const Span &column, SpanRecord &record)
    {
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstRow;
        record.endDrawn = column.endRow;
    }
    static void record(const Sample &sample, SampleRecord &record) { record.level = sample.level; }
    /// The colours depend on the set-up too: this records what the sample alone knows.
    static void record(const CurrentSample<SetUp, Span, Sample> &step, SampleRecord &record)
    {
        const StrokeSampleState state = stateOf(step);
        for (std::size_t channel = 0; channel < 3; ++channel)
            record.colour[channel] = state.level(channel);
    }
};

} // namespace pixelplumb
