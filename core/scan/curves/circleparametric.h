// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/curves/circleshape.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

#include <cmath>
#include <numbers>

/// The parametric form of the circle, x = r·cos θ and y = r·sin θ (Scan Conversion slides, "Lines
/// and Curves: Parametric"), in steps of 1/r: one pixel of arc. An ellipse takes steps of one over
/// its larger radius, at most one pixel long.
namespace pixelplumb {

template <class Float>
struct CircleParametricSetUp {
    Round round;
    Float angleStep = 0; ///< radians
    std::int64_t steps = 1; ///< for a full turn
};

template <class Float>
struct CircleParametricStep {
    std::int64_t number = 0;
    Float angle = 0; ///< θ, radians
    Float curveX = 0, curveY = 0; ///< px
    std::int64_t x = 0, y = 0; ///< the nearest pixel
};

template <class Float>
struct CircleParametricNumbers {
    using SetUp = CircleParametricSetUp<Float>;
    using Span = CircleParametricStep<Float>;
    using Sample = FlatSample;
};

template <FloatingNumber Float>
CircleParametricStep<Float> parametricStepAt(const CircleParametricSetUp<Float> &setUp,
                                             std::int64_t number)
{
    using std::cos;
    using std::sin;
    using Traits = NumberTraits<Float>;
    CircleParametricStep<Float> step;
    step.number = number;
    step.angle = Float(number) * setUp.angleStep;
    step.curveX = Traits::fromLattice(setUp.round.centre.x)
        + Traits::fromLattice(setUp.round.radiusX) * cos(step.angle);
    step.curveY = Traits::fromLattice(setUp.round.centre.y)
        + Traits::fromLattice(setUp.round.radiusY) * sin(step.angle);
    step.x = Traits::floor(step.curveX + Float(0.5));
    step.y = Traits::floor(step.curveY + Float(0.5));
    return step;
}

/// Walks the steps [first, end). A run of steps whose middle is farther from the frame than the run
/// is long draws nothing and is skipped: halving finds the part of a huge circle that passes the
/// frame.
template <FloatingNumber Float, class Observer>
void walkParametricSteps(const CircleParametricSetUp<Float> &setUp, std::int64_t first,
                         std::int64_t end, const Colour &colour, FrameView frame,
                         Observer &observer)
{
    if (first >= end)
        return;
    [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
    const std::int64_t middle = first + (end - first) / 2;
    const CircleParametricStep<Float> step = parametricStepAt(setUp, middle);
    // An arc is never shorter than its chord; the rounding of huge coordinates is allowed as much
    // again.
    const std::int64_t reach = 2 * (end - first) + 2;
    const bool isNear = step.x >= frame.firstColumn - reach && step.x < frame.endColumn() + reach
        && step.y >= frame.firstRow - reach && step.y < frame.endRow() + reach;
    if (!isNear)
        return;
    walkParametricSteps(setUp, first, middle, colour, frame, observer);
    if (frame.contains(step.x, step.y)) {
        observer.spanEntered(step);
        writeFlat(step.x, step.y, colour, frame, observer);
    }
    walkParametricSteps(setUp, middle + 1, end, colour, frame, observer);
}

template <FloatingNumber Float, ScanObserver<CircleParametricNumbers<Float>> Observer>
void scanCircleParametrically(const Shape &shape, FrameView frame, Observer observer)
{
    CircleParametricSetUp<Float> setUp;
    setUp.round = Round::of(shape);
    const Lattice largest = std::max(setUp.round.radiusX, setUp.round.radiusY);
    if (largest > 0) {
        setUp.angleStep = Float(unitsPerPixel) / Float(largest);
        const double around = 2 * std::numbers::pi * double(largest) / double(unitsPerPixel);
        setUp.steps = std::int64_t(std::ceil(around));
    }
    observer.primitiveBegun(setUp);
    if (!setUp.round.mayTouch(frame)) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    walkParametricSteps(setUp, 0, setUp.steps, shape.vertices[0].colour, frame, observer);
}

} // namespace pixelplumb
