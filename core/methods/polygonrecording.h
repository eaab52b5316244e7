// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/polygonnumbers.h"
#include "core/methods/polygonwords.h"
#include "core/trace/tracerecorder.h"

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

    /// Fills this one row again, in a frame of its own, with the same numbers.
    template <class Observer>
    static void walk(const SetUp &setUp, const Span &row, const ScanSettings &, Observer observer)
    {
        const std::int64_t width = row.endDrawn - row.firstDrawn;
        if (width <= 0)
            return;
        std::vector<QRgb> pixels(std::size_t(width), QRgb(0));
        const FrameView frame{
            pixels.data(),       std::ptrdiff_t(width), std::int32_t(row.firstDrawn),
            std::int32_t(row.y), std::int32_t(width),   1};
        fillRow(row, setUp, frame, observer);
    }
};

} // namespace pixelplumb
