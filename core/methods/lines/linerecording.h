// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/lines/linenumbers.h"
#include "core/methods/lines/linewords.h"
#include "core/trace/spanpixels.h"
#include "core/trace/statesof.h"

#include <cmath>
#include <concepts>

namespace pixelplumb {

inline const LinePlace &placeIn(const BresenhamSpan &span) { return span.step.place; }
template <class Step>
const LinePlace &placeIn(const Step &step)
{
    return step.place;
}

/// Whether a coordinate lies half-way between two pixels.
inline bool isHalfWay(const Quantity &coordinate)
{
    return coordinate.isRational() ? coordinate.denominator() == 2
                                   : std::abs(std::remainder(coordinate.toDouble(), 1)) == 0.5;
}

/// Whether two pixels are equally near in the numbers of the kernel.
inline bool isTie(const BresenhamSpan &span)
{
    return !span.step.isStart() && span.step.decision == 0;
}
inline bool isTie(const SymmetricStep &step) { return !step.isFirst && step.decision == 0; }
template <class Step>
bool isTie(const Step &step)
{
    if constexpr (std::derived_from<Step, SymmetricStep>) {
        return isTie(static_cast<const SymmetricStep &>(step));
    } else if constexpr (requires { step.ordinate; }) {
        return isHalfWay(quantityOf(step.ordinate));
    } else {
        return isHalfWay(quantityOf(step.x)) || isHalfWay(quantityOf(step.y));
    }
}

/// How the one pixel of a line's step becomes records, whatever the method.
template <class A, class Numbers>
struct LineStepRecording : Numbers {
    using typename Numbers::Sample;
    using typename Numbers::SetUp;
    using typename Numbers::Span;

    static SpanPlace placeOf(const Span &step)
    {
        const LinePlace &place = placeIn(step);
        return {place.axis == LineAxis::X ? SpanAxis::Column : SpanAxis::Row, place.along, 0};
    }
    static bool isClamped(const Sample &fragment) { return fragment.isClamped(); }

    static void record(const Sample &fragment, SampleRecord &record)
    {
        record.colour = quantitiesOf(fragment.colour);
        record.level = fragment.level;
    }

    static void walk(const SetUp &, const Span &step, const ScanSettings &settings,
                     ObserverOf<Numbers> observer)
    {
        const LinePlace &place = placeIn(step);
        if (!place.isInFrame)
            return;
        const SpanPixels pixel(LineStepRecording::placeOf(step), place.across, place.across + 1);
        plot<A>(place, step.colour, settings.rounding, pixel.view(), observer);
    }

    static void record(const SetUp &, SetUpRecord &) { }
    static void record(const Span &step, SpanRecord &record)
    {
        const LinePlace &place = placeIn(step);
        record.firstSample = place.across;
        record.endSample = place.across + 1;
        record.isTie = isTie(step);
        record.firstDrawn = place.across;
        record.endDrawn = place.across + (place.isInFrame ? 1 : 0);
    }

    /// All numbers of a step are in its span.
    static const NumberTable<Sample> &sampleNumbers()
    {
        static const NumberTable<Sample> none;
        return none;
    }
    static auto stateOf(const CurrentSetUp<SetUp> &step) { return lineStateOf(step.setUp); }
    static auto stateOf(const CurrentSpan<SetUp, Span> &step)
    {
        return lineStateOf(step.setUp, step.span);
    }
    static const Sample &stateOf(const CurrentSample<SetUp, Span, Sample> &step)
    {
        return step.sample;
    }
    template <class State>
    static auto tell(StepWords &words, const State &state) -> decltype(tellLine(words, state))
    {
        tellLine(words, state);
    }
};

template <class A>
struct SlopeInterceptRecording : LineStepRecording<A, SlopeInterceptNumbers<A>> {
    static const auto &setUpNumbers() { return slopeInterceptSetUpNumbers(); }
    static const auto &spanNumbers() { return slopeInterceptNumbers(); }
};

template <class A>
struct DdaRecording : LineStepRecording<A, DdaNumbers<A>> {
    static const auto &setUpNumbers() { return ddaSetUpNumbers(); }
    static const auto &spanNumbers() { return ddaNumbers(); }
};

template <class A>
struct ParametricLineRecording : LineStepRecording<A, ParametricLineNumbers<A>> {
    using typename LineStepRecording<A, ParametricLineNumbers<A>>::Span;

    static const auto &setUpNumbers() { return parametricLineSetUpNumbers(); }
    static const auto &spanNumbers() { return parametricLineNumbers(); }

    /// Neither column nor row: a point for each t.
    static SpanPlace placeOf(const Span &step) { return {SpanAxis::Free, step.number, 0}; }
};

struct BresenhamRecording : LineStepRecording<BresenhamArithmetic, BresenhamNumbers> {
    static const auto &setUpNumbers() { return bresenhamSetUpNumbers(); }
    static const auto &spanNumbers() { return decisionNumbers(); }
};

struct SymmetricRecording : LineStepRecording<ExactArithmetic<Int128>, SymmetricNumbers> {
    static const auto &setUpNumbers() { return symmetricSetUpNumbers(); }
    static const auto &spanNumbers() { return decisionNumbers(); }
};

} // namespace pixelplumb
