// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/lines/linestep.h"
#include "core/scan/mistakes/variededge.h"
#include "core/scan/walks/columnscan.h"

/// The digital differential analyzer (Rasterization slides, "DDA Line-Drawing Algorithm"): walk the
/// longer side pixel by pixel, add the slope to the other coordinate and round it for each pixel.
namespace pixelplumb {

template <class A>
struct DdaSetUp {
    LineAxis axis = LineAxis::X;
    Vertex start, end; ///< exchanged; start.position.x <= end.position.x
    VariantSet variants; ///< departures that change the slope
    typename A::Number slope = {}; ///< m: px across the line per step
    std::array<typename A::Number, 3> colourRate = {}; ///< levels per step
};

template <class A>
struct DdaStep {
    LinePlace place;
    typename A::Number ordinate = {}; ///< v: the line's position across, px; not rounded
    std::array<typename A::Number, 3> colour = {}; ///< levels
};

template <class A>
struct DdaNumbers {
    using SetUp = DdaSetUp<A>;
    using Span = DdaStep<A>;
    using Sample = Fragment<A>;
};

template <class A, ScanObserver<DdaNumbers<A>> Observer>
void scanLineByDda(const Shape &line, const ScanSettings &settings, FrameView frame,
                   Observer observer)
{
    DdaSetUp<A> setUp;
    setUp.axis = lineAxisOf(line.vertices[0].position, line.vertices[1].position);
    Vertex a = exchanged(line.vertices[0], setUp.axis);
    Vertex b = exchanged(line.vertices[1], setUp.axis);
    if (b.position.x < a.position.x)
        std::swap(a, b);
    setUp.start = a;
    setUp.end = b;
    setUp.variants = settings.variants;
    if (!A::represents(a.position) || !A::represents(b.position)) {
        observer.primitiveBegun(setUp);
        observer.primitiveRejected(PrimitiveRejection::NotRepresentable);
        return;
    }
    const VariedEdge walked = variedEdge(a, b, edgeChangesOf(settings.variants));
    // The quotients that the walker starts with.
    if constexpr (readsNumbers<Observer>) {
        setUp.slope = A::edgeSlope(walked.a, walked.b);
        setUp.colourRate = threeOf(
            [&](std::size_t channel) { return A::edgeColourRate(walked.a, walked.b, channel); });
    }
    observer.primitiveBegun(setUp);

    const StepRange steps
        = StepRange{ceilPixel(a.position.x), floorPixel(b.position.x) + 1}.clippedTo(
            StepRange::along(frame, setUp.axis));
    const auto [lowest, highest] = std::minmax(a.position.y, b.position.y);
    StepRange reached = StepRange{floorPixel(lowest), ceilPixel(highest) + 1}.clippedTo(
        StepRange::across(frame, setUp.axis));
    if (!settings.variants.isEmpty()) // variants may lead past the ends
        reached = StepRange::across(frame, setUp.axis);
    if (steps.isEmpty() || reached.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    EdgeWalker<A> walker(walked.a, walked.b, steps.first);
    for (std::int64_t along = steps.first; along < steps.end; ++along) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        // ⌊v + 1/2⌋: what rounding a level to the nearest byte does.
        const std::int64_t across = A::level(walker.y, ByteRounding::Nearest);
        DdaStep<A> step = {{setUp.axis, along, across}, walker.y, walker.colour};
        step.place.findIn(frame);
        observer.spanEntered(step);
        plot<A>(step.place, step.colour, settings.rounding, frame, observer);
        walker.stepToNextColumn();
    }
}

} // namespace pixelplumb
