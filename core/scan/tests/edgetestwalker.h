// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/three.h"
#include "core/scan/tests/edgetestsetup.h"

namespace pixelplumb {

/// Computes the samples along a span, as the form prescribes.
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

    /// A sample as the form computes it: from its coordinates, or from the numbers that the
    /// increments have reached.
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

    /// Take one step along the span or from span to span. They increment the values of edge
    /// equations, or the weights and colours of barycentric coordinates.
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
        const auto valueOf = [&](std::size_t line) {
            return m_setUp.lines[line].template valueAt<form.line>(point);
        };
        if constexpr (form.inside == InsideTest::Cramer) // w follows from u and v
            sample.value = {valueOf(0), valueOf(1), {}};
        else
            sample.value = threeOf(valueOf);
        if constexpr (form.isBarycentric())
            evaluateWeights(sample);
    }

    [[gnu::always_inline]] void evaluateWeights(Sample &sample) const
    {
        const auto weightOf
            = [&](std::size_t line) { return A::ratio(sample.value[line], m_whole[line]); };
        if constexpr (form.inside == InsideTest::Cramer) {
            sample.weight[0] = weightOf(0);
            sample.weight[1] = weightOf(1);
            sample.weight[2] = 1 - sample.weight[0] - sample.weight[1];
        } else {
            sample.weight = threeOf(weightOf);
        }
    }

    /// Edge equations need weights only when a sample is to be coloured.
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
    std::array<typename A::Divisor, 3> m_whole; ///< the values at the opposite vertices
};

} // namespace pixelplumb
