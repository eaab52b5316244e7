// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/curves/circleshape.h"
#include "core/scan/curves/flatpixel.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"
#include "core/scan/workstage.h"

/// The explicit form of the circle, y = ±√(r² − x²) (Scan Conversion slides, "Lines and Curves:
/// Explicit"), and of the ellipse, y = ±(b/a)·√(a² − x²): two pixels for each column, and gaps
/// where the curve is steep.
namespace pixelplumb {

/// The root in one arithmetic, and the rounding of centre ± root.
template <class A>
struct ExplicitRoot;

/// The exact root may be irrational; its whole part in lattice units decides every rounding.
template <class Integer>
struct ExplicitRoot<ExactArithmetic<Integer>> {
    using Number = Lattice;

    static Number root(const Round &round, Lattice distance)
    {
        return halfChord<WideBeside<Integer>>(round.radiusX, round.radiusY, distance);
    }
    static std::int64_t above(Lattice centre, Number root)
    {
        return floorPixel(centre + root + unitsPerPixel / 2);
    }
    static std::int64_t below(Lattice centre, Number root)
    {
        return ceilPixel(centre - root - unitsPerPixel / 2);
    }
};

template <FloatingNumber Float>
struct ExplicitRoot<RoundedArithmetic<Float>> {
    using Number = Float;
    using Traits = NumberTraits<Float>;

    static Number root(const Round &round, Lattice distance)
    {
        const Number a = Traits::fromLattice(round.radiusX);
        const Number x = Traits::fromLattice(distance);
        const Number square = a * a - x * x;
        using std::sqrt;
        const Number chord = sqrt(std::max(square, Number(0)));
        if (round.isCircle())
            return chord;
        const Number b = Traits::fromLattice(round.radiusY);
        return round.radiusX == 0 ? b : b / a * chord;
    }
    static std::int64_t above(Lattice centre, Number root)
    {
        return Traits::floor(Traits::fromLattice(centre) + root + Number(0.5));
    }
    static std::int64_t below(Lattice centre, Number root)
    {
        return Traits::ceil(Traits::fromLattice(centre) - root - Number(0.5));
    }
};

template <class A>
struct CircleExplicitStep {
    std::int64_t number = 0; ///< counts columns from the leftmost one
    std::int64_t x = 0; ///< px
    Lattice distance = 0; ///< from the centre, lattice units
    typename ExplicitRoot<A>::Number root = {}; ///< px; lattice units in exact arithmetic
    std::int64_t above = 0; ///< the row of the upper pixel
    std::int64_t below = 0;
};

template <class A>
struct CircleExplicitNumbers {
    using SetUp = Round;
    using Span = CircleExplicitStep<A>;
    using Sample = FlatSample;
};

template <class A, ScanObserver<CircleExplicitNumbers<A>> Observer>
void scanCircleExplicitly(const Shape &shape, FrameView frame, Observer observer)
{
    const Round round = Round::of(shape);
    observer.primitiveBegun(round);
    const StepRange columns = round.columns().clippedTo(StepRange::along(frame, LineAxis::X));
    if (columns.isEmpty() || !round.mayTouch(frame)) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    const Colour colour = shape.vertices[0].colour;
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        CircleExplicitStep<A> step;
        step.number = x - round.columns().first;
        step.x = x;
        step.distance = x * unitsPerPixel - round.centre.x;
        step.root = ExplicitRoot<A>::root(round, step.distance);
        step.above = ExplicitRoot<A>::above(round.centre.y, step.root);
        step.below = ExplicitRoot<A>::below(round.centre.y, step.root);
        observer.spanEntered(step);
        writeFlat(x, step.above, colour, frame, observer);
        if (step.below != step.above)
            writeFlat(x, step.below, colour, frame, observer);
    }
}

} // namespace pixelplumb
