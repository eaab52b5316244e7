// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/tests/edgetest.h"
#include "core/scan/tests/mistakenedgetest.h"

namespace pixelplumb {

/// Like testSamples(), with the bugs of the settings, in exact numbers. A triangle of zero area has
/// none. The set-up announced is that of a right program.
template <class A, EdgeTestForm form, class Observer>
void testSamplesMistaken(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                         Observer observer)
{
    const BoundaryRule rule{settings, frame};
    const EdgeTestSetUp<A> setUp = edgeTestSetUp<A, form>(triangle, rule, frame, settings.variants);
    const SampleBox box
        = form.visited == VisitedSamples::Frame ? boundingBoxOf(triangle) : setUp.visited;
    if (setUp.zeroArea || setUp.tested.isEmpty()) {
        testSamples<A, form>(triangle, settings, frame, observer);
        return;
    }
    observer.primitiveBegun(setUp);
    const MistakenEdgeTest program(settings.testBugs, triangle, rule, box);
    const auto sampleAt = [&](std::int64_t x, std::int64_t y) {
        TestedSample<A> sample;
        const EdgeFunctions functions = program.functionsAt(x, y);
        const VertexWeights weights = program.weightsOf(functions);
        for (std::size_t line = 0; line < 3; ++line) {
            const EdgeEnds ends = edgeEndsOf(form, line);
            const Int128 value = functions.values[ends.from];
            sample.value[line] = form.isBarycentric() ? value * program.turn() : value;
            if (program.hasArea())
                sample.weight[line]
                    = A::fraction(weights.numerators[ends.opposite], weights.denominator);
        }
        const bool isAsked = x >= box.firstX && y >= box.firstY && y < box.endY
            && x < program.endOfRow(y) && program.hasArea();
        sample.covered = isAsked && program.isInside(functions);
        if (sample.covered)
            sample.colour = threeOf([&](std::size_t channel) {
                const CommonFraction level = program.levelOf(weights, channel);
                return A::fraction(level.numerator, level.denominator);
            });
        return sample;
    };
    const auto test = [&](const EdgeTestSpan<A> &span) {
        colourSpan<A, form>(span, settings.rounding, frame, observer, sampleAt);
    };
    walkSpans<A, form>(setUp, {}, observer, test, [](EdgeTestSpan<A> &) {});
}

} // namespace pixelplumb
