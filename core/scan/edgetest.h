// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/number/three.h"
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

    explicit SpanWalker(const SetUp &setUp)
        : m_setUp(setUp)
    {
    }

    /// What the form makes of a sample: by its coordinates, or by the numbers that the increments
    /// have reached.
    Sample sampleAt(std::int64_t x, std::int64_t y, const EdgeTestSpan<A> &numbers) const
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
    void start(EdgeTestSpan<A> &numbers, std::int64_t x, std::int64_t y) const
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
    void stepX(EdgeTestSpan<A> &numbers) const
    {
        step(numbers, &EdgeLine<A>::a, m_setUp.weightPerX, m_setUp.colourPerX);
    }
    void stepY(EdgeTestSpan<A> &numbers) const
    {
        step(numbers, &EdgeLine<A>::b, m_setUp.weightPerY, m_setUp.colourPerY);
    }

private:
    void evaluate(Sample &sample, std::int64_t x, std::int64_t y) const
    {
        const LatticePoint point = latticePixel(x, y);
        sample.value = threeOf([&](std::size_t line) {
            return m_setUp.lines[line].template valueAt<form.line>(point);
        });
        if constexpr (form.isBarycentric())
            evaluateWeights(sample);
    }

    void evaluateWeights(Sample &sample) const
    {
        sample.weight = threeOf([&](std::size_t line) {
            return A::ratio(sample.value[line], m_setUp.atOpposite[line]);
        });
        if constexpr (form.inside == InsideTest::Cramer)
            sample.weight[2] = 1 - sample.weight[0] - sample.weight[1];
    }

    /// Edge equations have no use for weights until a sample is to be coloured.
    void evaluateColour(Sample &sample) const
    {
        if constexpr (!form.isBarycentric())
            evaluateWeights(sample);
        sample.colour = threeOf(
            [&](std::size_t channel) { return weightedLevel(m_setUp, sample.weight, channel); });
    }

    bool covers(const Sample &sample) const
    {
        if constexpr (form.inside == InsideTest::Signs) {
            return acceptsSign(sample.value[0], 0) && acceptsSign(sample.value[1], 1)
                && acceptsSign(sample.value[2], 2);
        } else if constexpr (form.inside == InsideTest::Cramer) {
            const Ratio sum = sample.weight[0] + sample.weight[1];
            return acceptsSign(sample.weight[0], 0) && acceptsSign(sample.weight[1], 1)
                && (sum < 1 || (sum == 1 && m_setUp.ownsTie[2]));
        } else {
            const auto accepts = [&](std::size_t line) {
                if constexpr (form.inside == InsideTest::UnitInterval) {
                    if (!(sample.weight[line] <= 1))
                        return false;
                }
                return acceptsSign(sample.weight[line], line);
            };
            return accepts(0) && accepts(1) && accepts(2);
        }
    }

    template <class Value>
    bool acceptsSign(const Value &value, std::size_t line) const
    {
        return value > 0 || (value == 0 && m_setUp.ownsTie[line]);
    }

    void step(EdgeTestSpan<A> &numbers, typename A::Number EdgeLine<A>::*rate,
              const std::array<Ratio, 3> &weightRate, const std::array<Ratio, 3> &colourRate) const
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
};

/// What is made of a sample of a triangle of zero area, of which edge functions say nothing.
template <class A>
TestedSample<A> segmentSampleAt(const EdgeTestSetUp<A> &setUp, std::int64_t x, std::int64_t y)
{
    TestedSample<A> sample;
    sample.ofSegment = true;
    sample.covered = setUp.segment.covers(x, y);
    if (!sample.covered)
        return sample;
    sample.colour = threeOf([&](std::size_t channel) {
        const auto [numerator, denominator] = setUp.segment.level(channel, x, y);
        return A::fraction(numerator, denominator);
    });
    return sample;
}

/// Colours those samples of a span that are inside.
template <class A, EdgeTestForm form, class Observer, class SampleAt>
void colourSpan(const EdgeTestSpan<A> &span, ByteRounding rounding, FrameView frame,
                Observer observer, SampleAt sampleAt)
{
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

/// Tests the samples of one span and colours those inside. The set-up and the span's numbers are
/// all it reads, so that a span can be walked again, alone, with the same numbers.
template <class A, EdgeTestForm form, class Observer>
void testSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span, ByteRounding rounding,
              FrameView frame, Observer observer)
{
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    if (setUp.zeroArea) {
        colourSpan<A, form>(span, rounding, frame, observer, [&](std::int64_t x, std::int64_t y) {
            return segmentSampleAt(setUp, x, y);
        });
        return;
    }
    using Walker = SpanWalker<A, form>;
    const Walker walker(setUp);
    EdgeTestSpan<A> numbers = span;
    colourSpan<A, form>(span, rounding, frame, observer, [&](std::int64_t x, std::int64_t y) {
        const TestedSample<A> sample = walker.sampleAt(x, y, numbers);
        if constexpr (Walker::isIncremental) {
            if constexpr (form.order == LoopOrder::RowByRow)
                walker.stepX(numbers);
            else
                walker.stepY(numbers);
        }
        return sample;
    });
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
    const SampleBox &box = setUp.tested;
    if (box.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    using Walker = SpanWalker<A, form>;
    const Walker walker(setUp);
    EdgeTestSpan<A> span;
    span.firstSample = isRow ? setUp.visited.firstX : setUp.visited.firstY;
    span.endSample = isRow ? setUp.visited.endX : setUp.visited.endY;
    span.firstTested = isRow ? box.firstX : box.firstY;
    span.endTested = isRow ? box.endX : box.endY;
    if (Walker::isIncremental && !setUp.zeroArea)
        walker.start(span, box.firstX, box.firstY);
    const std::int64_t end = isRow ? box.endY : box.endX;
    for (span.coordinate = isRow ? box.firstY : box.firstX; span.coordinate < end;
         ++span.coordinate) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        observer.spanEntered(span);
        testSpan<A, form>(setUp, span, settings.rounding, frame, observer);
        if constexpr (Walker::isIncremental) {
            if constexpr (isRow)
                walker.stepY(span);
            else
                walker.stepX(span);
        }
    }
}

} // namespace pixelplumb
