// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/number/three.h"
#include "core/scan/degeneratesegment.h"
#include "core/scan/edgetestsetup.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// Scan conversion by testing samples: each is inside or outside by three edge functions (Scan
/// Conversion slides, "Edge Equations: Code") or by the three weights that they give (Triangles
/// slides, "for all x do for all y do"; Rasterization slides, "Barycentric Coordinates of P (2D)").
/// One kernel; a form says which of the slides' variants it is.
namespace pixelplumb {

/// The value of one line at every step along a span, as the form computes it.
template <class A, EdgeTestForm form>
class SpanWalker {
public:
    using SetUp = EdgeTestSetUp<A>;
    using Sample = TestedSample<A>;
    using Ratio = typename A::Ratio;

    static constexpr bool isIncremental = form.evaluation == Evaluation::Increments;

    [[gnu::always_inline]] explicit SpanWalker(const SetUp &setUp)
        : m_setUp(setUp)
        , m_whole(threeOf(
              [&](std::size_t line) { return typename A::Divisor(setUp.atOpposite[line]); }))
    {
    }

    /// What the form makes of a sample: by its coordinates, or by the numbers that the increments
    /// have reached.
    [[gnu::always_inline]] Sample sampleAt(std::int64_t x, std::int64_t y,
                                           const EdgeTestSpan<A> &numbers) const
    {
        Sample sample;
        if constexpr (isIncremental) {
            sample.value = numbers.value;
            sample.weight = numbers.weight;
            sample.colour = numbers.colour;
        } else {
            evaluate(sample, x, y);
        }
        sample.covered = covers(sample);
        if constexpr (!(isIncremental && form.isBarycentric())) {
            if (sample.covered)
                evaluateColour(sample);
        }
        return sample;
    }

    /// The numbers from which the increments start.
    [[gnu::always_inline]] void start(EdgeTestSpan<A> &numbers, std::int64_t x,
                                      std::int64_t y) const
    {
        Sample sample;
        evaluate(sample, x, y);
        evaluateColour(sample);
        numbers.value = sample.value;
        numbers.weight = sample.weight;
        numbers.colour = sample.colour;
    }

    /// Adds what one step along the span or from span to span adds. Of edge equations the values
    /// are incremental, of barycentric coordinates the weights and colours are.
    [[gnu::always_inline]] void stepX(EdgeTestSpan<A> &numbers) const
    {
        step(numbers, &EdgeLine<A>::a, m_setUp.weightPerX, m_setUp.colourPerX);
    }
    [[gnu::always_inline]] void stepY(EdgeTestSpan<A> &numbers) const
    {
        step(numbers, &EdgeLine<A>::b, m_setUp.weightPerY, m_setUp.colourPerY);
    }

private:
    [[gnu::always_inline]] void evaluate(Sample &sample, std::int64_t x, std::int64_t y) const
    {
        const LatticePoint point = latticePixel(x, y);
        sample.value = threeOf([&](std::size_t line) {
            return m_setUp.lines[line].template valueAt<form.line>(point);
        });
        if constexpr (form.isBarycentric())
            evaluateWeights(sample);
    }

    [[gnu::always_inline]] void evaluateWeights(Sample &sample) const
    {
        sample.weight = threeOf(
            [&](std::size_t line) { return A::ratio(sample.value[line], m_whole[line]); });
        if constexpr (form.inside == InsideTest::Cramer)
            sample.weight[2] = 1 - sample.weight[0] - sample.weight[1];
    }

    /// Edge equations have no use for weights until a sample is to be coloured.
    [[gnu::always_inline]] void evaluateColour(Sample &sample) const
    {
        if constexpr (!form.isBarycentric())
            evaluateWeights(sample);
        sample.colour = threeOf(
            [&](std::size_t channel) { return weightedLevel(m_setUp, sample.weight, channel); });
    }

    [[gnu::always_inline]] bool covers(const Sample &sample) const
    {
        if constexpr (form.inside == InsideTest::Signs) {
            return accepts(sample.value[0], 0) && accepts(sample.value[1], 1)
                && accepts(sample.value[2], 2);
        } else if constexpr (form.inside == InsideTest::Cramer) {
            const Ratio sum = sample.weight[0] + sample.weight[1];
            return accepts(sample.weight[0], 0) && accepts(sample.weight[1], 1)
                && (m_setUp.ownsTie[2] ? sum <= 1 : sum < 1);
        } else {
            return accepts(sample.weight[0], 0) && accepts(sample.weight[1], 1)
                && accepts(sample.weight[2], 2);
        }
    }

    template <class Value>
    bool accepts(const Value &value, std::size_t line) const
    {
        if constexpr (form.inside == InsideTest::UnitInterval) {
            if (!(value <= 1))
                return false;
        }
        return A::isInside(value, m_setUp.ownsTie[line]);
    }

    [[gnu::always_inline]] void step(EdgeTestSpan<A> &numbers,
                                     typename A::Number EdgeLine<A>::*rate,
                                     const std::array<Ratio, 3> &weightRate,
                                     const std::array<Ratio, 3> &colourRate) const
    {
        if constexpr (form.isBarycentric()) {
            numbers.weight
                = threeOf([&](std::size_t i) { return numbers.weight[i] + weightRate[i]; });
            numbers.colour
                = threeOf([&](std::size_t i) { return numbers.colour[i] + colourRate[i]; });
        } else {
            numbers.value = threeOf([&](std::size_t i) {
                return numbers.value[i] + m_setUp.lines[i].*rate * A::length(unitsPerPixel);
            });
        }
    }

    const SetUp &m_setUp;
    std::array<typename A::Divisor, 3> m_whole; ///< by the values at the opposite vertices
};

/// What is made of a sample of a triangle of zero area, of which edge functions say nothing.
template <class A>
TestedSample<A> segmentSampleAt(const DegenerateSegment &segment, std::int64_t x, std::int64_t y)
{
    TestedSample<A> sample;
    sample.ofSegment = true;
    sample.covered = segment.covers(x, y);
    if (!sample.covered)
        return sample;
    sample.colour = threeOf([&](std::size_t channel) {
        const auto [numerator, denominator] = segment.level(channel, x, y);
        return A::fraction(numerator, denominator);
    });
    return sample;
}

/// Colours those samples of a span that are inside. Inlined by order, as what calls it is: a call
/// would keep the innermost numbers in memory.
template <class A, EdgeTestForm form, class Observer, class SampleAt>
[[gnu::always_inline]] inline void colourSpan(const EdgeTestSpan<A> &span, ByteRounding rounding,
                                              FrameView frame, Observer observer, SampleAt sampleAt)
{
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    for (std::int64_t along = span.firstTested; along < span.endTested; ++along) {
        const std::int64_t x = isRow ? along : span.coordinate;
        const std::int64_t y = isRow ? span.coordinate : along;
        TestedSample<A> sample = sampleAt(x, y);
        QRgb *pixel = frame.at(x, y);
        if (sample.covered) {
            sample.level = threeOf(
                [&](std::size_t channel) { return A::level(sample.colour[channel], rounding); });
            const QRgb after = pixelOfLevels(sample.level);
            observer.pixelWritten(x, y, *pixel, after, sample);
            *pixel = after;
        } else {
            observer.sampleRejected(x, y, *pixel, sample);
        }
    }
}

/// Tests the samples of one span of a triangle that has area and colours those inside.
template <class A, EdgeTestForm form, class Observer>
[[gnu::always_inline]] inline void testTriangleSpan(const SpanWalker<A, form> &walker,
                                                    const EdgeTestSpan<A> &span,
                                                    ByteRounding rounding, FrameView frame,
                                                    Observer observer)
{
    EdgeTestSpan<A> numbers = span;
    colourSpan<A, form>(
        span, rounding, frame,
        observer, [&](std::int64_t x, std::int64_t y) __attribute__((always_inline)) {
            const TestedSample<A> sample = walker.sampleAt(x, y, numbers);
            if constexpr (SpanWalker<A, form>::isIncremental) {
                if constexpr (form.order == LoopOrder::RowByRow)
                    walker.stepX(numbers);
                else
                    walker.stepY(numbers);
            }
            return sample;
        });
}

/// The same of a triangle that has none.
template <class A, EdgeTestForm form, class Observer>
void testSegmentSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span,
                     ByteRounding rounding, FrameView frame, Observer observer)
{
    const DegenerateSegment segment(Triangle{setUp.vertices});
    colourSpan<A, form>(span, rounding, frame, observer, [&](std::int64_t x, std::int64_t y) {
        return segmentSampleAt<A>(segment, x, y);
    });
}

/// Walks a span again, alone, with the same numbers: the set-up and the span's numbers are all that
/// it reads.
template <class A, EdgeTestForm form, class Observer>
void testSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span, ByteRounding rounding,
              FrameView frame, Observer observer)
{
    if (setUp.zeroArea)
        testSegmentSpan<A, form>(setUp, span, rounding, frame, observer);
    else
        testTriangleSpan(SpanWalker<A, form>(setUp), span, rounding, frame, observer);
}

/// Walks the spans of the box, from the first on; `test(span)` tests the samples of one.
template <class A, EdgeTestForm form, class Observer, class Test, class Step>
[[gnu::always_inline]] inline void walkSpans(const EdgeTestSetUp<A> &setUp, EdgeTestSpan<A> span,
                                             Observer observer, Test test, Step stepToNext)
{
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    const SampleBox &box = setUp.tested;
    span.firstSample = isRow ? setUp.visited.firstX : setUp.visited.firstY;
    span.endSample = isRow ? setUp.visited.endX : setUp.visited.endY;
    span.firstTested = isRow ? box.firstX : box.firstY;
    span.endTested = isRow ? box.endX : box.endY;
    const std::int64_t end = isRow ? box.endY : box.endX;
    for (span.coordinate = isRow ? box.firstY : box.firstX; span.coordinate < end;
         ++span.coordinate) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        observer.spanEntered(span);
        test(span);
        stepToNext(span);
    }
}

/// A triangle of zero area. Its set-up is a copy, so that the numbers of all others can stay in
/// registers.
template <class A, EdgeTestForm form, class Observer>
[[gnu::noinline]] void testSegment(EdgeTestSetUp<A> setUp, ByteRounding rounding, FrameView frame,
                                   Observer observer)
{
    const auto test = [&](const EdgeTestSpan<A> &span) {
        testSegmentSpan<A, form>(setUp, span, rounding, frame, observer);
    };
    walkSpans<A, form>(setUp, {}, observer, test, [](EdgeTestSpan<A> &) {});
}

/// The test of one triangle's samples.
template <class A, EdgeTestForm form, ScanObserver<EdgeTestNumbers<A>> Observer>
void testSamples(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                 Observer observer)
{
    const EdgeTestSetUp<A> setUp = edgeTestSetUp<A, form>(triangle, {settings, frame}, frame);
    observer.primitiveBegun(setUp);
    if (setUp.zeroArea && settings.fillRule != FillRule::Closed) {
        observer.primitiveRejected(PrimitiveRejection::ZeroArea);
        return;
    }
    if (setUp.tested.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    if (setUp.zeroArea) {
        testSegment<A, form>(setUp, settings.rounding, frame, observer);
        return;
    }
    using Walker = SpanWalker<A, form>;
    const Walker walker(setUp);
    EdgeTestSpan<A> first;
    if constexpr (Walker::isIncremental)
        walker.start(first, setUp.tested.firstX, setUp.tested.firstY);
    const auto test = [&](const EdgeTestSpan<A> &span) __attribute__((always_inline))
    {
        testTriangleSpan(walker, span, settings.rounding, frame, observer);
    };
    walkSpans<A, form>(
        setUp, first, observer, test, [&](EdgeTestSpan<A> & span) __attribute__((always_inline)) {
            if constexpr (Walker::isIncremental) {
                if constexpr (form.order == LoopOrder::RowByRow)
                    walker.stepY(span);
                else
                    walker.stepX(span);
            }
        });
}

} // namespace pixelplumb
