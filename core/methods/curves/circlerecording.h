// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/curvenumbers.h"
#include "core/methods/curves/flatrecording.h"
#include "core/trace/spanpixels.h"

namespace pixelplumb {

struct CircleFillRecording : CircleFillNumbers, FlatRecording {
    using FlatRecording::record;
    using FlatRecording::stateOf;

    static const auto &setUpNumbers() { return roundSetUpNumbers(); }
    static const auto &spanNumbers() { return circleFillNumbers(); }
    static CircleFillState stateOf(const CurrentSpan<Round, CircleFillRow> &step)
    {
        return {step.setUp, step.span};
    }

    static SpanPlace placeOf(const Span &row) { return {SpanAxis::Row, row.y, 0}; }
    static void record(const Span &row, SpanRecord &record)
    {
        record.lower = Quantity::rational(row.left, unitsPerPixel);
        record.upper = Quantity::rational(row.right, unitsPerPixel);
        record.firstSample = row.firstSample;
        record.endSample = row.endSample;
        record.firstDrawn = row.firstDrawn;
        record.endDrawn = row.endDrawn;
    }
    static void walk(const Round &, const Span &row, const ScanSettings &,
                     ObserverOf<CircleFillNumbers> observer)
    {
        const SpanPixels pixels(placeOf(row), row.firstDrawn, row.endDrawn);
        if (!pixels.isEmpty())
            fillRow(row, pixels.view(), observer);
    }
};

template <class A>
struct CircleExplicitRecording : CircleExplicitNumbers<A>, FlatRecording {
    using Span = CircleExplicitStep<A>;
    using FlatRecording::stateOf;

    static const auto &setUpNumbers() { return roundSetUpNumbers(); }
    static const auto &spanNumbers() { return circleExplicitNumbers(); }
    static auto stateOf(const CurrentSpan<Round, Span> &step)
    {
        return circleStateOf(step.span, step.setUp);
    }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
};

template <class Float>
struct CircleParametricRecording : CircleParametricNumbers<Float>, FlatRecording {
    using SetUp = CircleParametricSetUp<Float>;
    using Span = CircleParametricStep<Float>;
    using FlatRecording::stateOf;

    static const auto &setUpNumbers() { return circleParametricSetUpNumbers(); }
    static const auto &spanNumbers() { return circleParametricNumbers(); }
    static auto stateOf(const CurrentSetUp<SetUp> &step) { return circleStateOf(step.setUp); }
    static auto stateOf(const CurrentSpan<SetUp, Span> &step) { return circleStateOf(step.span); }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.number); }
};

struct MidpointRecording : MidpointNumbers, FlatRecording {
    static const auto &setUpNumbers() { return midpointSetUpNumbers(); }
    static const auto &spanNumbers() { return circleMidpointNumbers(); }

    static SpanPlace placeOf(const Span &step) { return freeStep(step.x, step.arc); }
};

} // namespace pixelplumb
