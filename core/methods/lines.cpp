// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines.h"

#include "core/methods/linekernels.h"

namespace pixelplumb {

namespace {

/// What all line methods have in common.
template <class Kernel>
Method lineMethod()
{
    Method method = methodOf<Kernel>();
    method.family = MethodFamily::Lines;
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.kinds = {PrimitiveKind::Line};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a line has no inside that an edge could bound");
    return method;
}

} // namespace

Method lineSlopeInterceptMethod()
{
    Method method = lineMethod<SlopeInterceptKernel>();
    method.id = QStringLiteral("line-slope-intercept");
    method.title = QStringLiteral("Line: y = m·x + b");
    method.source = QStringLiteral("Rasterization slides, “Line-Drawing Algorithms” and "
                                   "“Example”; Scan Conversion slides, “Lines and Curves: "
                                   "Explicit”");
    method.summary = QStringLiteral("Computes y = m·x + b for each column and rounds it by "
                                    "(int)(y + ½): steep lines have gaps, vertical ones no m.");
    method.remarks += QStringLiteral("gaps where |m| > 1");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    return method;
}

Method lineParametricMethod()
{
    Method method = lineMethod<ParametricLineKernel>();
    method.id = QStringLiteral("line-parametric");
    method.title = QStringLiteral("Line: P(t)");
    method.source = QStringLiteral("Scan Conversion slides, “Lines and Curves: Parametric”");
    method.summary = QStringLiteral("Computes P(t) = P₀ + t·(P₁ − P₀) for t in steps of one pixel "
                                    "of the longer side, or less, and writes the pixel nearest to "
                                    "each point.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.variants = {Variant::TwiceT, Variant::FiveT};
    return method;
}

Method lineDdaMethod()
{
    Method method = lineMethod<DdaKernel>();
    method.id = QStringLiteral("line-dda");
    method.title = QStringLiteral("Line: DDA");
    method.source = QStringLiteral("Rasterization slides, “DDA Line-Drawing Algorithm”");
    method.summary = QStringLiteral("Walks along the longer side and adds the slope at each step; "
                                    "the pixel is the nearest one.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.variants = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne};
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

Method lineBresenhamMethod()
{
    Method method = lineMethod<BresenhamKernel>();
    method.id = QStringLiteral("line-bresenham");
    method.title = QStringLiteral("Line: Bresenham");
    method.source = QStringLiteral("Rasterization slides, “Bresenham's Line Algorithm (1/4)” to "
                                   "“(4/4)” and “Bresenham: Example”");
    method.summary = QStringLiteral("Steps from the left end to the right by the sign of an "
                                    "integer; p_k < 0 stays, so that ties go up on a rising line "
                                    "and down on a falling one.");
    method.remarks += QStringLiteral("whole-pixel end points");
    method.variants = {Variant::StayAtZero, Variant::OneStepShort};
    return method;
}

Method lineSymmetricMethod()
{
    Method method = lineMethod<SymmetricKernel>();
    method.id = QStringLiteral("line-bresenham-symmetric");
    method.title = QStringLiteral("Line: Bresenham, sub-pixel ends");
    method.source = QStringLiteral("stable form of the Rasterization slides, “Bresenham's Line "
                                   "Algorithm”");
    method.summary
        = QStringLiteral("Bresenham's decisions from any lattice point to any other, "
                         "ties to the upper or right pixel whether the line rises or falls.");
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

} // namespace pixelplumb
