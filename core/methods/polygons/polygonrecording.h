// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/polygons/polygonnumbers.h"
#include "core/methods/polygons/polygonwords.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

namespace pixelplumb {

/// How the numbers of a polygon's rows become records. A row of a whole polygon has any even number
/// of crossings, of which the first few are shown; a row of a triangle has two, its bounds.
template <class A, PolygonForm Form>
struct PolygonRecording : PolygonNumbers<A> {
    using typename PolygonNumbers<A>::SetUp;
    using typename PolygonNumbers<A>::Span;
    using typename PolygonNumbers<A>::Sample;

    static SpanPlace placeOf(const Span &row) { return {SpanAxis::Row, row.y, row.piece}; }
    static bool isClamped(const Sample &) { return false; }

    static const NumberTable<SetUp> &setUpNumbers()
    {
        static const auto table = polygonSetUpNumbers(Form);
        return table;
    }
    static const NumberTable<PolygonRowState> &spanNumbers()
    {
        static const auto table = polygonRowNumbers(Form);
        return table;
    }
    static const NumberTable<PolygonSampleState> &sampleNumbers()
    {
        static const auto table = polygonSampleNumbers(Form);
        return table;
    }

    static const SetUp &stateOf(const CurrentSetUp<SetUp> &step) { return step.setUp; }
    static PolygonRowState stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return polygonStateOf<A>(step, shownCrossings(Form));
    }
    static PolygonSampleState stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return polygonStateOf<A>(step);
    }

    /// A triangle's row needs no words beyond its bounds.
    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellPolygon(words, state))
    {
        if constexpr (!isInTriangles(Form)
                      || (Form == PolygonForm::CrossingTriangles && std::same_as<State, SetUp>))
            tellPolygon(words, state);
    }

    static void record(const SetUp &, SetUpRecord &) { }
    static void record(const Span &row, SpanRecord &record)
    {
        record.firstSample = row.firstSample;
        record.endSample = row.endSample;
        record.firstDrawn = row.firstDrawn;
        record.endDrawn = row.endDrawn;
        if constexpr (isInTriangles(Form)) {
            record.lower = Quantity::of(row.crossings.front().x);
            record.upper = Quantity::of(row.crossings.back().x);
        }
    }
    static void record(const Sample &sample, SampleRecord &record)
    {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            record.level[channel] = sample.colour.channels[channel];
            record.colour[channel] = Quantity::integer(record.level[channel]);
        }
    }

    static void walk(const SetUp &setUp, const Span &row, const ScanSettings &,
                     ObserverOf<PolygonNumbers<A>> observer)
    {
        const SpanPixels pixels(placeOf(row), row.firstDrawn, row.endDrawn);
        if (!pixels.isEmpty())
            fillRow(row, setUp, pixels.view(), observer);
    }
};

} // namespace pixelplumb
