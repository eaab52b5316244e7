// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/shadednumbers.h"
#include "core/methods/shading/shadedsteps.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of shaded triangles become records. A sample depends on what its pixel held, so
/// columns cannot be walked again: samples are kept.
template <class N, class A>
struct ShadedRecording : ShadedNumbers<N, A> {
    using typename ShadedNumbers<N, A>::SetUp;
    using typename ShadedNumbers<N, A>::Span;
    using typename ShadedNumbers<N, A>::Sample;

    static auto setUpNumbers(const ShadedScope &scope = {}) { return shadedSetUpNumbers(scope); }
    static auto spanNumbers(const ShadedScope &scope = {}) { return shadedSpanNumbers(scope); }
    static auto sampleNumbers(const ShadedScope &scope = {}) { return shadedSampleNumbers(scope); }

    static ShadedSetUpState stateOf(const CurrentSetUp<SetUp> &step)
    {
        return shadedStateOf<N, A>(step.setUp);
    }
    static ShadedSpanState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return shadedStateOf<N, A>(step);
    }
    static ShadedSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return shadedStateOf<N, A>(step);
    }
    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellShaded(words, state))
    {
        tellShaded(words, state);
    }

    static SpanPlace placeOf(const Span &column)
    {
        return {SpanAxis::Column, column.x, int(column.half)};
    }
    static bool isClamped(const Sample &sample) { return sample.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        if (setUp.form == InterpolationForm::Bilinear) {
            record.order = setUp.order;
            record.longEdge = setUp.longEdge;
        }
        record.zeroArea = setUp.zeroArea;
    }
    static void record(const Span &column, SpanRecord &record)
    {
        if (column.origin == ColumnOrigin::None)
            return;
        record.lower = quantityOf(column.lower);
        record.upper = quantityOf(column.upper);
        record.longEdge = column.longEdge;
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawn;
        record.endDrawn = column.endDrawn;
    }
    /// The colours depend on the set-up too: this records what the sample alone knows.
    static void record(const Sample &sample, SampleRecord &record) { record.level = sample.level; }
    static void record(const CurrentSample<SetUp, Span, Sample> &step, SampleRecord &record)
    {
        if (step.sample.samples.count() > 0 || step.fate == SampleFate::Refused)
            return;
        const ShadedQuantities<N> quantities(step.setUp);
        for (std::size_t i = 0; i < 3; ++i)
            record.colour[i] = step.setUp.effects.smooth ? quantities.value(step.sample, i)
                                                         : Quantity::integer(step.sample.level[i]);
    }
};

} // namespace pixelplumb
