// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/anyarithmetic.h"
#include "core/methods/words/formulatext.h"
#include "core/scan/lines/linedda.h"
#include "core/scan/lines/lineparametric.h"
#include "core/scan/lines/lineslopeintercept.h"
#include "core/scan/lines/linesymmetric.h"

/// What the tables of line methods read: the numbers of the kernels as quantities.
namespace pixelplumb {

template <>
struct LineEquation<AnyArithmetic> {
    using Number = Quantity;
};

using SlopeInterceptSetUpState = SlopeInterceptSetUp<AnyArithmetic>;
using SlopeInterceptState = SlopeInterceptStep<AnyArithmetic>;

struct DdaSetUpState : DdaSetUp<AnyArithmetic> {
    /// Both ends are one point: there is no slope.
    bool isPoint() const { return start.position.x == end.position.x; }
    /// Δ − 1 leaves nothing to divide by.
    bool isTooShort() const
    {
        return variants.contains(Variant::DivisorMinusOne)
            && end.position.x - start.position.x <= unitsPerPixel;
    }
};
struct DdaState : DdaStep<AnyArithmetic> {
    bool isPoint = false;
    bool hasPreStep = true; ///< from the first end to the first pixel
};

using ParametricLineSetUpState = ParametricLineSetUp<AnyArithmetic>;
struct ParametricLineState : ParametricLineStep<AnyArithmetic> {
    Quantity t;
    std::int64_t pace = 1;
};

/// For a line led by the sign of a decision parameter.
struct DecisionSetUpState {
    LineAxis axis = LineAxis::X;
    Quantity startX, startY; ///< x₀, y₀, px; exchanged where the line is steep
    Quantity endX, endY; ///< x₁, y₁
    Quantity deltaX, deltaY; ///< Δx, Δy, px
    Quantity stayIncrement, moveIncrement; ///< 2Δy, 2Δy − 2Δx
    Quantity firstDecision; ///< p₀; none for a line that may begin between pixels
    /// c of p_k = 2Δy·x_k ∓ 2Δx·y_k + c, + where the line falls; none without p₀. The kernel does
    /// not need it: it cancels from pixel to pixel.
    Quantity constant;
    bool falls = false;
};

struct DecisionState {
    LinePlace place;
    int acrossStep = 1; ///< −1 where the line falls
    Quantity k, decision, increment; ///< of the decision that led here; none at the first pixel
    Quantity nextDecision; ///< p_k+1; none for a point
    bool movesAcross = false; ///< that decision went one across
    bool startsLine = false; ///< no decision led here, because the line starts on this very pixel
    /// y of the line at this pixel, exchanged, px; none at a first pixel where the line starts
    Quantity ordinate;
    /// From Bresenham's set-up: c, 2Δy and 2Δx; none without c.
    Quantity constant, perColumn, perRow;

    bool isLedByDecision() const { return !k.isNone(); }
    bool isSteep() const { return place.axis == LineAxis::Y; }
    bool falls() const { return acrossStep < 0; }
    /// y_k: the previous pixel's position across the line.
    std::int64_t acrossBefore() const { return place.across - (movesAcross ? acrossStep : 0); }
    /// d_lower: how far the line has gone across from there, in its own direction. d_upper is the
    /// rest of the way to the next pixel across.
    Quantity distanceToLower() const { return isLedByDecision() ? distance(0) : Quantity(); }
    Quantity distanceToUpper() const { return isLedByDecision() ? distance(1) : Quantity(); }

private:
    /// From the pixel `across` px past the previous one, towards the line.
    Quantity distance(int across) const
    {
        const Int128 unit = ordinate.denominator();
        const Int128 gone = acrossStep * (ordinate.numerator() - acrossBefore() * unit);
        return Quantity::rational(across == 0 ? gone : unit - gone, unit);
    }
};

/// y of the line at `along`, px; its ends are in units of 1/`unit` px; none for a point.
inline Quantity ordinateAt(const LatticePoint &start, Int128 deltaX, Int128 rise, Int128 unit,
                           std::int64_t along)
{
    if (deltaX == 0)
        return {};
    const Int128 run = Int128(along) * unit - start.x;
    return Quantity::rational(start.y * deltaX + run * rise, deltaX * unit);
}

template <class A>
SlopeInterceptSetUpState lineStateOf(const SlopeInterceptSetUp<A> &setUp)
{
    return {quantityOf(setUp.slope), quantityOf(setUp.intercept), setUp.start, setUp.end};
}
template <class A>
SlopeInterceptState lineStateOf(const SlopeInterceptSetUp<A> &, const SlopeInterceptStep<A> &step)
{
    return {step.place, quantityOf(step.ordinate), quantitiesOf(step.colour)};
}
template <class A>
DdaSetUpState lineStateOf(const DdaSetUp<A> &setUp)
{
    return {{setUp.axis, setUp.start, setUp.end, setUp.variants, quantityOf(setUp.slope),
             quantitiesOf(setUp.colourRate)}};
}
template <class A>
DdaState lineStateOf(const DdaSetUp<A> &setUp, const DdaStep<A> &step)
{
    return {{step.place, quantityOf(step.ordinate), quantitiesOf(step.colour)},
            setUp.start.position.x == setUp.end.position.x,
            !setUp.variants.contains(Variant::NoEdgePreStep)};
}

template <class A>
ParametricLineSetUpState lineStateOf(const ParametricLineSetUp<A> &setUp)
{
    return {setUp.start, setUp.end, setUp.steps, setUp.pace};
}
template <class A>
ParametricLineState lineStateOf(const ParametricLineSetUp<A> &setUp,
                                const ParametricLineStep<A> &step)
{
    return {{step.place, step.number, quantityOf(step.x), quantityOf(step.y),
             quantitiesOf(step.colour)},
            Quantity::rational(step.number, setUp.steps),
            setUp.pace};
}

inline DecisionSetUpState lineStateOf(const BresenhamSetUp &setUp)
{
    const Int128 across = setUp.acrossStep * 2 * Int128(setUp.deltaX) * setUp.start.y;
    const Int128 constant
        = setUp.firstDecision - Int128(setUp.stayIncrement) * setUp.start.x + across;
    return {setUp.axis,
            Quantity::integer(setUp.start.x),
            Quantity::integer(setUp.start.y),
            Quantity::integer(setUp.start.x + setUp.alongStep * setUp.deltaX),
            Quantity::integer(setUp.start.y + setUp.acrossStep * setUp.deltaY),
            Quantity::integer(setUp.deltaX),
            Quantity::integer(setUp.deltaY),
            Quantity::integer(setUp.stayIncrement),
            Quantity::integer(setUp.moveIncrement),
            Quantity::integer(setUp.firstDecision),
            Quantity::integer(constant),
            setUp.acrossStep < 0};
}
inline DecisionState lineStateOf(const BresenhamSetUp &setUp, const BresenhamSpan &span)
{
    const BresenhamStep &step = span.step;
    DecisionState state;
    state.place = step.place;
    state.acrossStep = setUp.acrossStep;
    state.startsLine = step.isStart();
    const DecisionSetUpState numbers = lineStateOf(setUp);
    state.constant = numbers.constant;
    state.perColumn = numbers.stayIncrement;
    state.perRow = Quantity::integer(2 * Int128(setUp.deltaX));
    if (setUp.deltaX > 0)
        state.nextDecision = Quantity::integer(step.nextDecision);
    if (step.isStart())
        return state;
    state.k = Quantity::integer(step.k);
    state.decision = Quantity::integer(step.decision);
    state.increment = Quantity::integer(step.increment);
    state.movesAcross = step.increment == setUp.moveIncrement;
    state.ordinate = ordinateAt(setUp.start, setUp.deltaX, setUp.acrossStep * setUp.deltaY, 1,
                                step.place.along);
    return state;
}

inline DecisionSetUpState lineStateOf(const SymmetricSetUp &setUp)
{
    constexpr Int128 unit = SymmetricSetUp::decisionUnit();
    return {setUp.axis,
            pixels(setUp.start.position.x),
            pixels(setUp.start.position.y),
            pixels(setUp.end.position.x),
            pixels(setUp.end.position.y),
            pixels(setUp.deltaX),
            pixels(setUp.deltaY),
            Quantity::rational(setUp.stayIncrement, unit),
            Quantity::rational(setUp.moveIncrement, unit),
            {},
            {},
            setUp.acrossStep < 0};
}
inline DecisionState lineStateOf(const SymmetricSetUp &setUp, const SymmetricStep &step)
{
    constexpr Int128 unit = SymmetricSetUp::decisionUnit();
    DecisionState state;
    state.place = step.place;
    state.acrossStep = setUp.acrossStep;
    if (setUp.deltaX > 0)
        state.nextDecision = Quantity::rational(step.nextDecision, unit);
    const LatticePoint &start = setUp.start.position;
    state.startsLine = step.isFirst && start.x == step.place.along * unitsPerPixel
        && start.y == step.place.across * unitsPerPixel;
    if (!state.startsLine)
        state.ordinate = ordinateAt(start, setUp.deltaX, Int128(setUp.acrossStep) * setUp.deltaY,
                                    unitsPerPixel, step.place.along);
    if (step.isFirst)
        return state;
    state.k = Quantity::integer(step.k);
    state.decision = Quantity::rational(step.decision, unit);
    state.increment = Quantity::rational(step.increment, unit);
    state.movesAcross = step.increment == setUp.moveIncrement;
    return state;
}

} // namespace pixelplumb
