// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/scan/curves/circleexplicit.h"
#include "core/scan/curves/circlefill.h"
#include "core/scan/curves/circleparametric.h"

/// What the tables of the two circle methods with a choice of arithmetic read: the kernels' numbers
/// as quantities.
namespace pixelplumb {

template <>
struct ExplicitRoot<AnyArithmetic> {
    using Number = Quantity;
};

/// A row of a filled circle, with the circle.
struct CircleFillState {
    const Round &round;
    const CircleFillRow &row;
};

struct CircleExplicitState : CircleExplicitStep<AnyArithmetic> {
    Round round;
};

struct CircleParametricSetUpState {
    Round round;
    Quantity angleStep; ///< radians
};

struct CircleParametricState {
    std::int64_t number = 0;
    Quantity angle; ///< θ, radians
    Quantity curveX, curveY; ///< px
    std::int64_t x = 0, y = 0; ///< the nearest pixel
};

/// The root of exact arithmetic, rounded down to the lattice.
inline Quantity rootIn(Lattice root) { return Quantity::rational(root, unitsPerPixel); }
template <std::floating_point Float>
Quantity rootIn(Float root)
{
    return Quantity::of(root);
}

template <class A>
CircleExplicitState circleStateOf(const CircleExplicitStep<A> &step, const Round &round)
{
    return {{step.number, step.x, step.distance, rootIn(step.root), step.above, step.below}, round};
}
template <class Float>
CircleParametricSetUpState circleStateOf(const CircleParametricSetUp<Float> &setUp)
{
    return {setUp.round, Quantity::of(setUp.angleStep)};
}
template <class Float>
CircleParametricState circleStateOf(const CircleParametricStep<Float> &step)
{
    return {step.number,
            Quantity::of(step.angle),
            Quantity::of(step.curveX),
            Quantity::of(step.curveY),
            step.x,
            step.y};
}

} // namespace pixelplumb
