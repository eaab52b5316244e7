// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/edgewalknumbers.h"
#include "core/methods/walks/edgewalkwords.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of an edge walk become records, each sample's kept.
template <class A, EdgeWalkForm form>
struct EdgeWalkRecords : EdgeWalkNumbers<A> {
    using typename EdgeWalkNumbers<A>::SetUp;
    using typename EdgeWalkNumbers<A>::Span;
    using typename EdgeWalkNumbers<A>::Sample;

    static constexpr bool isRow = form.axis == SpanAxis::Row;

    static const NumberTable<EdgeWalkSetUpState> &setUpNumbers()
    {
        static const auto table = edgeWalkSetUpNumbers(form);
        return table;
    }
    static const NumberTable<EdgeWalkSpanState> &spanNumbers()
    {
        static const auto table = edgeWalkSpanNumbers(form);
        return table;
    }
    static const NumberTable<EdgeWalkSampleState> &sampleNumbers()
    {
        static const auto table = edgeWalkSampleNumbers(form);
        return table;
    }

    static EdgeWalkSetUpState stateOf(const CurrentSetUp<SetUp> &step)
    {
        return edgeWalkStateOf<A>(step);
    }
    static EdgeWalkSpanState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return edgeWalkStateOf<A>(step);
    }
    static EdgeWalkSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return edgeWalkStateOf<A>(step, isRow ? step.x : step.y);
    }
    template <class State>
    static void tell(StepWords &words, const State &state)
    {
        EdgeWalkWords(form).tell(words, state);
    }

    static SpanPlace placeOf(const Span &column)
    {
        return {form.axis, across(column.x), int(column.half)};
    }
    static bool isClamped(const Sample &fragment) { return fragment.isClamped(); }

    static void record(const SetUp &setUp, SetUpRecord &record)
    {
        record.order = setUp.scan.order;
        record.longEdge = setUp.scan.longEdge;
        record.zeroArea = setUp.scan.zeroArea;
    }
    static void record(const Span &column, SpanRecord &record)
    {
        record.lower = quantityOf(column.yBottom);
        record.upper = quantityOf(column.yTop);
        record.longEdge = column.longEdge;
        record.firstSample = column.firstRow;
        record.endSample = column.endRow;
        record.firstDrawn = column.firstDrawn;
        record.endDrawn = column.endDrawn;
    }
    static void record(const Sample &fragment, SampleRecord &record)
    {
        record.colour = quantitiesOf(fragment.colour);
        record.level = fragment.level;
    }

private:
    static constexpr std::int64_t across(std::int64_t column) { return isRow ? -column : column; }
};

/// Of a right walk, whose samples are walked again from their span.
template <class A, EdgeWalkForm form>
struct EdgeWalkRecording : EdgeWalkRecords<A, form> {
    static void walk(const EdgeWalkSetUp<A> &, const ColumnState<A> &column,
                     const ScanSettings &settings, ObserverOf<EdgeWalkNumbers<A>> observer)
    {
        const SpanPixels pixels(EdgeWalkRecords<A, form>::placeOf(column), column.firstDrawn,
                                column.endDrawn);
        if (pixels.isEmpty())
            return;
        using View = std::conditional_t<form.axis == SpanAxis::Row, TurnedView, FrameView>;
        const Triangle none;
        fillColumn(column, settings.rounding, View(pixels.view()),
                   EdgeWalkListener<A, form.axis, decltype(observer)>(none, {}, column.firstDrawn,
                                                                      observer));
    }
};

} // namespace pixelplumb
