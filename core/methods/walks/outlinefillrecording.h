// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/outlinefillnumbers.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of a filled outline become records.
template <class A>
struct OutlineFillRecording : OutlineFillNumbers<A> {
    using typename OutlineFillNumbers<A>::SetUp;
    using typename OutlineFillNumbers<A>::Span;
    using typename OutlineFillNumbers<A>::Sample;

    static const auto &setUpNumbers() { return outlineSetUpNumbers(); }
    static const auto &spanNumbers() { return outlineSpanNumbers(); }
    static const auto &sampleNumbers() { return outlineSampleNumbers(); }

    static const SetUp &stateOf(const CurrentSetUp<SetUp> &step) { return step.setUp; }
    static OutlineSpanState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return outlineStateOf<A>(step);
    }
    static OutlineSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return outlineStateOf<A>(step);
    }
    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellOutline(words, state))
    {
        tellOutline(words, state);
    }

    static SpanPlace placeOf(const Span &span) { return {SpanAxis::Column, span.column.x, 0}; }
    static bool isClamped(const Sample &fragment) { return fragment.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        const auto &[p0, p1, p2] = setUp.corners;
        record.zeroArea = doubledArea(p0.position, p1.position, p2.position) == 0;
    }
    static void record(const Span &span, SpanRecord &record)
    {
        record.firstSample = span.column.firstRow;
        record.endSample = span.column.endRow;
        record.firstDrawn = span.column.firstDrawn;
        record.endDrawn = span.column.endDrawn;
    }
    /// A column is a tie where a decision parameter that led to one of its bounds was 0.
    static void record(const CurrentSpan<SetUp, Span> &step, SpanRecord &record)
    {
        const auto isTie = [&step](const OutlinePixel &bound) {
            return outlineDecisionOf(step.setUp, bound).parameter == Quantity::integer(0);
        };
        record.isTie = isTie(step.span.low) || isTie(step.span.high);
    }
    static void record(const Sample &fragment, SampleRecord &record)
    {
        record.colour = quantitiesOf(fragment.colour);
        record.level = fragment.level;
    }

    static void walk(const SetUp &, const Span &span, const ScanSettings &settings,
                     ObserverOf<OutlineFillNumbers<A>> observer)
    {
        const SpanPixels pixels(placeOf(span), span.column.firstDrawn, span.column.endDrawn);
        if (!pixels.isEmpty())
            fillColumn(span.column, settings.rounding, pixels.view(), observer);
    }
};

} // namespace pixelplumb
