// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/linedda.h"
#include "core/scan/lineslopeintercept.h"
#include "core/scan/linesymmetric.h"
#include "core/trace/tracerecorder.h"

namespace pixelplumb {

inline const LinePlace &placeIn(const BresenhamSpan &span) { return span.step.place; }
template <class Step>
const LinePlace &placeIn(const Step &step)
{
    return step.place;
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
        for (std::size_t channel = 0; channel < 3; ++channel)
            record.colour[channel] = Quantity::of(fragment.colour[channel]);
        record.level = fragment.level;
    }

    /// Plots the pixel into a frame of its own, with the same numbers.
    template <class Observer>
    static void walk(const SetUp &, const Span &step, const ScanSettings &settings,
                     Observer observer)
    {
        const LinePlace &place = placeIn(step);
        if (!place.isInFrame)
            return;
        QRgb pixel = 0;
        const FrameView frame{&pixel, 1, std::int32_t(place.x()), std::int32_t(place.y()), 1, 1};
        plot<A>(place, step.colour, settings.rounding, frame, observer);
    }

protected:
    static void recordPlace(const Span &step, SpanRecord &record)
    {
        const LinePlace &place = placeIn(step);
        record.firstSample = place.across;
        record.endSample = place.across + 1;
        record.firstDrawn = place.across;
        record.endDrawn = place.across + (place.isInFrame ? 1 : 0);
    }
    template <class Cells, class Number>
    static void append(Cells &cells, const std::array<Number, 3> &numbers)
    {
        for (const Number &number : numbers)
            cells.push_back(Quantity::of(number));
    }
    static Quantity quantity(const ExactRatio &ratio)
    {
        return Quantity::rational(ratio.numerator, ratio.denominator);
    }
    template <class Number>
    static Quantity quantity(const Number &number)
    {
        return Quantity::of(number);
    }
    static Quantity px(Lattice units) { return Quantity::rational(units, unitsPerPixel); }
};

template <class A>
struct DdaRecording : LineStepRecording<A, DdaNumbers<A>> {
    using Base = LineStepRecording<A, DdaNumbers<A>>;
    using Base::record;

    static void record(const DdaSetUp<A> &setUp, SetUpRecord &record)
    {
        record.cells
            = {Base::px(setUp.start.x), Base::px(setUp.start.y), Quantity::of(setUp.slope)};
        Base::append(record.cells, setUp.colourRate);
    }
    static void record(const DdaStep<A> &step, SpanRecord &record)
    {
        Base::recordPlace(step, record);
        record.cells = {Quantity::integer(step.place.x()), Quantity::integer(step.place.y()),
                        Quantity::integer(step.place.along), Quantity::of(step.ordinate),
                        Quantity::integer(step.place.across)};
        Base::append(record.cells, step.colour);
    }
};

template <class A>
struct SlopeInterceptRecording : LineStepRecording<A, SlopeInterceptNumbers<A>> {
    using Base = LineStepRecording<A, SlopeInterceptNumbers<A>>;
    using Base::record;

    static void record(const SlopeInterceptSetUp<A> &setUp, SetUpRecord &record)
    {
        record.cells = {Base::px(setUp.startX), Base::quantity(setUp.slope),
                        Base::quantity(setUp.intercept)};
    }
    static void record(const SlopeInterceptStep<A> &step, SpanRecord &record)
    {
        Base::recordPlace(step, record);
        record.cells = {Quantity::integer(step.place.along), Base::quantity(step.ordinate),
                        Quantity::integer(step.place.across)};
        Base::append(record.cells, step.colour);
    }
};

struct BresenhamRecording : LineStepRecording<BresenhamArithmetic, BresenhamNumbers> {
    using LineStepRecording::record;

    static void record(const BresenhamSetUp &setUp, SetUpRecord &record)
    {
        record.cells
            = {Quantity::integer(setUp.deltaX), Quantity::integer(setUp.deltaY),
               Quantity::integer(setUp.stayIncrement()), Quantity::integer(setUp.moveIncrement()),
               Quantity::integer(setUp.firstDecision())};
    }
    static void record(const BresenhamSpan &span, SpanRecord &record)
    {
        recordPlace(span, record);
        const BresenhamStep &step = span.step;
        const auto unlessStart = [&](std::int64_t number) {
            return step.isStart() ? Quantity() : Quantity::integer(number);
        };
        record.cells = {unlessStart(step.k),
                        unlessStart(step.decision),
                        Quantity::integer(step.place.x()),
                        Quantity::integer(step.place.y()),
                        unlessStart(step.increment),
                        Quantity::integer(step.nextDecision)};
    }
};

struct SymmetricRecording : LineStepRecording<ExactArithmetic<Int128>, SymmetricNumbers> {
    using LineStepRecording::record;

    static void record(const SymmetricSetUp &setUp, SetUpRecord &record)
    {
        record.cells = {px(setUp.deltaX), px(setUp.deltaY), decision(setUp.stayIncrement()),
                        decision(setUp.moveIncrement())};
    }
    static void record(const SymmetricStep &step, SpanRecord &record)
    {
        recordPlace(step, record);
        const auto unlessFirst
            = [&](const Quantity &number) { return step.isFirst ? Quantity() : number; };
        record.cells
            = {unlessFirst(Quantity::integer(step.k)), unlessFirst(decision(step.decision)),
               Quantity::integer(step.place.x()),      Quantity::integer(step.place.y()),
               unlessFirst(decision(step.increment)),  decision(step.nextDecision)};
    }

private:
    static Quantity decision(Int128 number)
    {
        return Quantity::rational(number, SymmetricSetUp::decisionUnit());
    }
};

} // namespace pixelplumb
