// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/barycentricwords.h"
#include "core/methods/tests/edgetestnumbers.h"
#include "core/scan/tests/edgetest.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of an edge test become records, each sample's kept.
template <class A, EdgeTestForm form>
struct EdgeTestRecords : EdgeTestNumbers<A> {
    using typename EdgeTestNumbers<A>::SetUp;
    using typename EdgeTestNumbers<A>::Span;
    using typename EdgeTestNumbers<A>::Sample;

    static constexpr bool isRow = form.order == LoopOrder::RowByRow;

    static const NumberTable<EdgeTestSetUpState> &setUpNumbers()
    {
        static const auto table = edgeTestSetUpNumbers(form);
        return table;
    }
    static const NumberTable<EdgeTestSpanState> &spanNumbers()
    {
        static const auto table = edgeTestSpanNumbers(form);
        return table;
    }
    static const NumberTable<EdgeTestSampleState> &sampleNumbers()
    {
        static const auto table = edgeTestSampleNumbers(form);
        return table;
    }

    static EdgeTestSetUpState stateOf(const CurrentSetUp<SetUp> &step)
    {
        return edgeTestStateOf<A, form>(step.setUp);
    }
    static EdgeTestSpanState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return edgeTestStateOf<A>(step);
    }
    static EdgeTestSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return edgeTestStateOf<A, form>(step);
    }

    static SpanPlace placeOf(const Span &span)
    {
        return {isRow ? SpanAxis::Row : SpanAxis::Column, span.coordinate, 0};
    }
    static bool isClamped(const Sample &sample) { return sample.isClamped(); }

    /// Only for barycentric forms: edge functions already use the vertices' names.
    template <class State>
    static auto tell(StepWords &words, const State &state)
        -> decltype(tellBarycentric(words, state, form))
    {
        if constexpr (form.isBarycentric())
            tellBarycentric(words, state, form);
    }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.zeroArea = setUp.zeroArea;
    }
    static void record(const Span &span, SpanRecord &record)
    {
        record.firstSample = span.firstSample;
        record.endSample = span.endSample;
        record.firstDrawn = span.firstTested;
        record.endDrawn = span.endTested;
    }
    static void record(const Sample &sample, SampleRecord &record)
    {
        record.colour = edgeTestColourOf<A, form>(sample);
        record.level = sample.level;
    }
};

/// Of a right test, whose samples are tested again from their span.
template <class A, EdgeTestForm form>
struct EdgeTestRecording : EdgeTestRecords<A, form> {
    static void walk(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span,
                     const ScanSettings &settings, ObserverOf<EdgeTestNumbers<A>> observer)
    {
        const SpanPixels pixels(EdgeTestRecords<A, form>::placeOf(span), span.firstTested,
                                span.endTested);
        if (!pixels.isEmpty())
            testSpan<A, form>(setUp, span, settings.rounding, pixels.view(), observer);
    }
};

} // namespace pixelplumb
