// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/edgetestsetup.h"
#include "core/scan/scanobserver.h"

/// Scan conversion by testing samples: each is inside or outside by three edge functions (seed 003)
/// or by the three weights that they give (seeds 001 and 002). One kernel; a form says which of the
/// slides' variants it is.
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
        if (m_setUp.zeroArea) {
            decideBySegment(sample, x, y);
            return sample;
        }
        if constexpr (isIncremental) {
            sample.value = numbers.value;
            sample.weight = numbers.weight;
            sample.colour = numbers.colour;
        } else {
            evaluate(sample, x, y);
        }
        for (std::size_t line = 0; line < 3; ++line)
            sample.unit[line] = m_setUp.lines[line].unit;
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
        for (std::size_t line = 0; line < 3; ++line)
            sample.value[line] = m_setUp.lines[line].template valueAt<form.line>(point);
        if constexpr (form.isBarycentric())
            evaluateWeights(sample);
    }

    void evaluateWeights(Sample &sample) const
    {
        for (std::size_t line = 0; line < 3; ++line)
            sample.weight[line] = A::ratio(sample.value[line], m_setUp.atOpposite[line]);
        if constexpr (form.inside == InsideTest::Cramer)
            sample.weight[2] = 1 - sample.weight[0] - sample.weight[1];
    }

    /// Edge equations have no use for weights until a sample is to be coloured.
    void evaluateColour(Sample &sample) const
    {
        if constexpr (!form.isBarycentric())
            evaluateWeights(sample);
        for (std::size_t channel = 0; channel < 3; ++channel)
            sample.colour[channel] = weightedLevel<A, form>(m_setUp, sample.weight, channel);
    }

    void decideBySegment(Sample &sample, std::int64_t x, std::int64_t y) const
    {
        sample.ofSegment = true;
        sample.covered = m_setUp.segment.covers(x, y);
        if (!sample.covered)
            return;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const auto [numerator, denominator] = m_setUp.segment.level(channel, x, y);
            sample.colour[channel] = A::fraction(numerator, denominator);
        }
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
            bool inside = true;
            for (std::size_t line = 0; line < 3; ++line) {
                inside = inside && acceptsSign(sample.weight[line], line);
                if constexpr (form.inside == InsideTest::UnitInterval)
                    inside = inside && sample.weight[line] <= 1;
            }
            return inside;
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
        for (std::size_t i = 0; i < 3; ++i) {
            if constexpr (form.isBarycentric()) {
                numbers.weight[i] = numbers.weight[i] + weightRate[i];
                numbers.colour[i] = numbers.colour[i] + colourRate[i];
            } else {
                numbers.value[i]
                    = numbers.value[i] + m_setUp.lines[i].*rate * A::length(unitsPerPixel);
            }
        }
    }

    const SetUp &m_setUp;
};

/// Tests the samples of one span and colours those inside. The set-up and the span's numbers are
/// all it reads, so that a span can be walked again, alone, with the same numbers.
template <class A, EdgeTestForm form, class Observer>
void testSpan(const EdgeTestSetUp<A> &setUp, const EdgeTestSpan<A> &span, ByteRounding rounding,
              FrameView frame, Observer observer)
{
    using Walker = SpanWalker<A, form>;
    const Walker walker(setUp);
    constexpr bool isRow = form.order == LoopOrder::RowByRow;
    EdgeTestSpan<A> numbers = span;
    for (std::int64_t along = span.firstTested; along < span.endTested; ++along) {
        const std::int64_t x = isRow ? along : span.coordinate;
        const std::int64_t y = isRow ? span.coordinate : along;
        TestedSample<A> sample = walker.sampleAt(x, y, numbers);
        QRgb *pixel = frame.at(x, y);
        if (sample.covered) {
            std::array<int, 3> byte;
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sample.level[channel] = A::level(sample.colour[channel], rounding);
                byte[channel] = int(std::clamp<std::int64_t>(sample.level[channel], 0, 255));
            }
            const QRgb after = qRgb(byte[0], byte[1], byte[2]);
            observer.pixelWritten(x, y, *pixel, after, sample);
            *pixel = after;
        } else {
            observer.sampleRejected(x, y, *pixel, sample);
        }
        if constexpr (Walker::isIncremental) {
            if constexpr (isRow)
                walker.stepX(numbers);
            else
                walker.stepY(numbers);
        }
    }
}

/// The test of one triangle's samples.
template <class A, EdgeTestForm form, ScanObserver<EdgeTestNumbers<A>> Observer>
void testSamples(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                 Observer observer)
{
    const EdgeTestSetUp<A> setUp = edgeTestSetUp<A, form>(triangle, settings.fillRule, frame);
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
