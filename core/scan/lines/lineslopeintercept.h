// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/commonfraction.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/lines/linestep.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scanobserver.h"

/// The line equation taken literally (Rasterization slides, "Line-Drawing Algorithms"): y = m·x + b
/// for each column, and (int)(y + 1/2), which is how a C program rounds and which rounds negative
/// numbers the wrong way. One pixel per column: a line with |m| > 1 has gaps, a vertical one has no
/// m.
namespace pixelplumb {

/// m, b and y in one arithmetic.
template <class A>
struct LineEquation;

/// b of a steep line does not fit a mixed number's 64-bit whole.
template <class Integer>
struct LineEquation<ExactArithmetic<Integer>> {
    using Wide = WideBeside<Integer>;
    using Number = FractionOf<Wide>;

    static Number slope(const LatticePoint &a, const LatticePoint &b)
    {
        return {Wide(b.y) - a.y, Wide(b.x) - a.x};
    }
    static Number intercept(const LatticePoint &a, const LatticePoint &b, const Number &)
    {
        return ordinate(a, b, {}, {}, 0);
    }
    static Number ordinate(const LatticePoint &a, const LatticePoint &b, const Number &,
                           const Number &, std::int64_t x)
    {
        const Wide width = Wide(b.x) - a.x;
        const Wide run = Wide(x) * unitsPerPixel - a.x;
        return {a.y * width + run * (Wide(b.y) - a.y), width * unitsPerPixel};
    }
    /// (int)(y + 1/2): the quotient of two integers drops its fraction, as the cast does.
    static std::int64_t rounded(const Number &y)
    {
        return std::int64_t((2 * y.numerator + y.denominator) / (2 * y.denominator));
    }
};

template <class Value>
struct LineEquation<RoundedArithmetic<Value>> {
    using Number = Value;
    using Traits = NumberTraits<Value>;

    static Number slope(const LatticePoint &a, const LatticePoint &b)
    {
        return RoundedArithmetic<Value>::edgeSlope({a, {}}, {b, {}});
    }
    static Number intercept(const LatticePoint &a, const LatticePoint &, const Number &m)
    {
        return Traits::fromLattice(a.y) - m * Traits::fromLattice(a.x);
    }
    static Number ordinate(const LatticePoint &, const LatticePoint &, const Number &m,
                           const Number &b, std::int64_t x)
    {
        return m * Traits::fromInteger(x) + b;
    }
    static std::int64_t rounded(const Number &y)
    {
        const Number sum = y + Traits::fromInteger(1) / Traits::fromInteger(2);
        return sum < Traits::fromInteger(0) ? Traits::ceil(sum) : Traits::floor(sum);
    }
};

template <class A>
struct SlopeInterceptSetUp {
    typename LineEquation<A>::Number slope = {}; ///< m
    typename LineEquation<A>::Number intercept = {}; ///< b, px
    Vertex start, end; ///< from left to right
};

template <class A>
struct SlopeInterceptStep {
    LinePlace place;
    typename LineEquation<A>::Number ordinate = {}; ///< y, px
    std::array<typename A::Number, 3> colour = {}; ///< levels
};

template <class A>
struct SlopeInterceptNumbers {
    using SetUp = SlopeInterceptSetUp<A>;
    using Span = SlopeInterceptStep<A>;
    using Sample = Fragment<A>;
};

template <class A, ScanObserver<SlopeInterceptNumbers<A>> Observer>
void scanLineBySlopeIntercept(const Shape &line, ByteRounding rounding, FrameView frame,
                              Observer observer)
{
    using Equation = LineEquation<A>;
    const auto [a, b] = std::minmax(
        line.vertices[0], line.vertices[1],
        [](const Vertex &left, const Vertex &right) { return left.position.x < right.position.x; });
    SlopeInterceptSetUp<A> setUp;
    setUp.start = a;
    setUp.end = b;
    const bool isVertical = a.position.x == b.position.x;
    const bool isRepresentable = A::represents(a.position) && A::represents(b.position);
    if (!isVertical && isRepresentable) {
        setUp.slope = Equation::slope(a.position, b.position);
        setUp.intercept = Equation::intercept(a.position, b.position, setUp.slope);
    }
    observer.primitiveBegun(setUp);
    const StepRange columns
        = StepRange{ceilPixel(a.position.x), floorPixel(b.position.x) + 1}.clippedTo(
            StepRange::along(frame, LineAxis::X));
    if (isVertical || !isRepresentable) {
        observer.primitiveRejected(!isVertical ? PrimitiveRejection::NotRepresentable
                                       : a.position == b.position
                                       ? PrimitiveRejection::LineOfNoLength
                                       : PrimitiveRejection::VerticalLine);
        return;
    }
    if (columns.isEmpty()) {
        observer.primitiveRejected(PrimitiveRejection::OutsideFrame);
        return;
    }
    const auto colourRate = threeOf(
        [&](std::size_t channel) { return A::edgeColourRate(setUp.start, setUp.end, channel); });
    for (std::int64_t x = columns.first; x < columns.end; ++x) {
        [[maybe_unused]] const WorkScope work(observer, WorkStage::Span);
        SlopeInterceptStep<A> step;
        step.ordinate = Equation::ordinate(a.position, b.position, setUp.slope, setUp.intercept, x);
        step.place = {LineAxis::X, x, Equation::rounded(step.ordinate)};
        step.place.findIn(frame);
        const auto run = A::runTo(x, a);
        step.colour = threeOf([&](std::size_t channel) {
            return A::edgeColour(setUp.start, setUp.end, channel, run, colourRate[channel]);
        });
        observer.spanEntered(step);
        plot<A>(step.place, step.colour, rounding, frame, observer);
    }
}

} // namespace pixelplumb
