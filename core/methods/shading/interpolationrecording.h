// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/interpolationsteps.h"
#include "core/methods/shading/interpolationwords.h"
#include "core/methods/shading/shadednumbers.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of an interpolation become records: for R G B or, with room for all channels,
/// for those that are carried.
template <InterpolationForm Form, class Number, std::size_t channelsInAll = colourChannelCount>
struct InterpolationRecording : InterpolationNumbers<Number, channelsInAll> {
    using typename InterpolationNumbers<Number, channelsInAll>::SetUp;
    using typename InterpolationNumbers<Number, channelsInAll>::Span;
    using typename InterpolationNumbers<Number, channelsInAll>::Sample;

    static auto setUpNumbers(const ShadedScope &scope = interpolationScope(Form))
    {
        return shadedSetUpNumbers(scope);
    }
    static auto spanNumbers(const ShadedScope &scope = interpolationScope(Form))
    {
        return shadedSpanNumbers(scope);
    }
    static auto sampleNumbers(const ShadedScope &scope = interpolationScope(Form))
    {
        return shadedSampleNumbers(scope);
    }

    static ShadedSetUpState stateOf(const CurrentSetUp<SetUp> &step)
    {
        return interpolationStateOf<Form>(step.setUp);
    }
    static ShadedSpanState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return interpolationStateOf<Form, Number, channelsInAll>(step);
    }
    static ShadedSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return interpolationStateOf<Form, Number, channelsInAll>(step);
    }
    static void tell(StepWords &words, const ShadedSetUpState &state) { tellShaded(words, state); }
    static void tell(StepWords &words, const ShadedSpanState &state)
    {
        tellInterpolated(words, state, Form);
    }

    static SpanPlace placeOf(const Span &column)
    {
        constexpr SpanAxis axis = axisOf(Form);
        return {axis, axis == SpanAxis::Row ? -column.x : column.x, int(column.half)};
    }
    static bool isClamped(const Sample &sample) { return sample.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        if constexpr (isBilinear(Form)) {
            record.order = setUp.order;
            record.longEdge = setUp.longEdge;
        }
        record.zeroArea = setUp.zeroArea;
    }
    static void record(const Span &column, SpanRecord &record)
    {
        record.lower = Quantity::of(column.lower);
        record.upper = Quantity::of(column.upper);
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawn;
        record.endDrawn = column.endDrawn;
    }
    static void record(const Sample &sample, SampleRecord &record)
    {
        for (std::size_t i = 0; i < 3; ++i)
            record.colour[i] = Quantity::of(sample.value[i]);
        record.level = sample.level;
    }

    static void walk(const SetUp &setUp, const Span &column, const ScanSettings &settings,
                     ObserverOf<InterpolationNumbers<Number, channelsInAll>> observer)
    {
        const SpanPixels pixels(placeOf(column), column.firstDrawn, column.endDrawn);
        if (!pixels.isEmpty())
            fillAgain<Form>(setUp, column, settings.rounding, ViewOfForm<Form>(pixels.view()),
                            listenerFor<Form>(observer));
    }
};

} // namespace pixelplumb
