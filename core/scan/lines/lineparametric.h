// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/lines/linestep.h"
#include "core/scan/scanobserver.h"
#include "core/scan/scansettings.h"
#include "core/scan/workstage.h"

/// The parametric form of the line, P(t) = P₀ + t·(P₁ − P₀) for t from 0 to 1 (Scan Conversion
/// slides, "Lines and Curves: Parametric"): t = i/N in N steps, each at most one pixel along the
/// longer side; each point draws its nearest pixel. "Not unique!": P(kt) for t from 0 to 1/k is the
/// same line; with the same step of t its points are k times as far apart.
namespace pixelplumb {

template <class A>
struct ParametricLineSetUp {
    Vertex start, end; ///< as they are given
    std::int64_t steps = 1; ///< N, from t = 0 to 1
    std::int64_t pace = 1; ///< k
};

template <class A>
struct ParametricLineStep {
    LinePlace place; ///< along x
    std::int64_t number = 0; ///< i
    typename A::Number x = {}, y = {}; ///< P(t), px; not rounded
    std::array<typename A::Number, 3> colour = {}; ///< levels
};

template <class A>
struct ParametricLineNumbers {
    using SetUp = ParametricLineSetUp<A>;
    using Span = ParametricLineStep<A>;
    using Sample = Fragment<A>;
};

inline std::int64_t paceOf(VariantSet variants)
{
    return (variants.contains(Variant::TwiceT) ? 2 : 1)
        * (variants.contains(Variant::FiveT) ? 5 : 1);
}

/// The steps whose points lie in the frame's columns (rows of a steep line), or one pixel outside.
template <class A>
StepRange parametricStepsIn(const ParametricLineSetUp<A> &setUp, FrameView frame)
{
    const StepRange whole = {0, setUp.steps / setUp.pace + 1};
    const LineAxis axis = lineAxisOf(setUp.start.position, setUp.end.position);
    const Lattice from = exchanged(setUp.start, axis).position.x;
    const Int128 way = Int128(exchanged(setUp.end, axis).position.x - from) * setUp.pace;
    if (way == 0)
        return whole;
    const StepRange shown = StepRange::along(frame, axis);
    const auto stepAt = [&](std::int64_t pixel) {
        const Int128 run = (Int128(pixel) * unitsPerPixel - from) * setUp.steps;
        return std::int64_t(way > 0 ? floorDivide<Int128>(run, way)
                                    : floorDivide<Int128>(-run, -way));
    };
    const auto [first, last] = std::minmax({stepAt(shown.first - 1), stepAt(shown.end)});
    return StepRange{first, last + 2}.clippedTo(whole);
}

template <class A, ScanObserver<ParametricLineNumbers<A>> Observer>
void scanLineParametrically(const Shape &line, const ScanSettings &settings, FrameView frame,
                            Observer observer)
{
    ParametricLineSetUp<A> setUp;
    setUp.start = line.vertices[0];
    setUp.end = line.vertices[1];
    setUp.pace = paceOf(settings.variants);
    const LatticePoint &p0 = setUp.start.position;
    const LatticePoint &p1 = setUp.end.position;
    setUp.steps = std::max<std::int64_t>(
        1, ceilPixel(std::max(absolute(p1.x - p0.x), absolute(p1.y - p0.y))));
    observer.primitiveBegun(setUp);

    // x and y over i are lines themselves, from (0, x₀) to (N, x₁).
    const auto over
        = [&](const Vertex &vertex, Lattice LatticePoint::*coordinate, std::int64_t step) {
              return Vertex{{step * unitsPerPixel, vertex.position.*coordinate}, vertex.colour};
          };
    const Vertex x0 = over(setUp.start, &LatticePoint::x, 0);
    const Vertex x1 = over(setUp.end, &LatticePoint::x, setUp.steps);
    const Vertex y0 = over(setUp.start, &LatticePoint::y, 0);
    const Vertex y1 = over(setUp.end, &LatticePoint::y, setUp.steps);
    for (const Vertex *end : {&x0, &x1, &y0, &y1}) {
        if (!A::represents(end->position)) {
            observer.primitiveRejected(PrimitiveRejection::NotRepresentable);
            return;
        }
    }
    const StepRange steps = parametricStepsIn(setUp, frame);
    if (steps.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    const auto slopeX = A::edgeSlope(x0, x1);
    const auto slopeY = A::edgeSlope(y0, y1);
    const auto colourRate
        = threeOf([&](std::size_t channel) { return A::edgeColourRate(x0, x1, channel); });
    for (std::int64_t i = steps.first; i < steps.end; ++i) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        const auto run = A::runTo(i * setUp.pace, x0);
        ParametricLineStep<A> step;
        step.number = i;
        step.x = A::edgeOrdinate(x0, x1, run, slopeX);
        step.y = A::edgeOrdinate(y0, y1, run, slopeY);
        step.colour = threeOf([&](std::size_t channel) {
            return A::edgeColour(x0, x1, channel, run, colourRate[channel]);
        });
        // ⌊x + 1/2⌋: what rounding a level to the nearest byte does.
        step.place = {LineAxis::X, A::level(step.x, ByteRounding::Nearest),
                      A::level(step.y, ByteRounding::Nearest)};
        step.place.findIn(frame);
        observer.spanEntered(step);
        plot<A>(step.place, step.colour, settings.rounding, frame, observer);
    }
}

} // namespace pixelplumb
