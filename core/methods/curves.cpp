// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves.h"

#include "core/methods/bezierrecording.h"
#include "core/methods/curvekernels.h"

namespace pixelplumb {

namespace {

struct BezierKernel : ShapeKernel<PrimitiveKind::Bezier>, InIntegers {
    template <class>
    using Recording = BezierRecording;

    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        BezierScan<Observer>(shape, frame, observer).run();
    }
};

/// What the methods of this file have in common.
template <class Kernel>
Method curveMethod()
{
    Method method = methodOf<Kernel>();
    method.family = MethodFamily::Curves;
    method.effects = {Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a curve has no edges that two shapes could share");
    return method;
}

template <class Kernel>
Method outlineMethod()
{
    Method method = curveMethod<Kernel>();
    method.kinds = {PrimitiveKind::Circle, PrimitiveKind::Ellipse};
    method.fills = {ShapeFill::Outline};
    return method;
}

} // namespace

Method circleExplicitMethod()
{
    Method method = outlineMethod<ExplicitKernel>();
    method.id = QStringLiteral("circle-explicit");
    method.title = QStringLiteral("Circle: y = ±√(r² − x²)");
    method.source = QStringLiteral("Scan Conversion slides, “Lines and Curves: Explicit”");
    method.summary = QStringLiteral("Computes y = ±√(r² − x²) for each column; there are gaps "
                                    "where the curve is steep.");
    method.remarks += QStringLiteral("gaps where the curve is steep");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    return method;
}

Method circleParametricMethod()
{
    Method method = outlineMethod<ParametricKernel>();
    method.id = QStringLiteral("circle-parametric");
    method.title = QStringLiteral("Circle: (r cos θ, r sin θ)");
    method.source = QStringLiteral("Scan Conversion slides, “Lines and Curves: Parametric”");
    method.summary = QStringLiteral("Goes round in steps of one pixel of arc and writes the pixel "
                                    "nearest to each point (r cos θ, r sin θ).");
    method.arithmetics = {Arithmetic::Float64, Arithmetic::Float32};
    return method;
}

Method circleMidpointMethod()
{
    Method method = outlineMethod<MidpointKernel>();
    method.id = QStringLiteral("circle-midpoint");
    method.title = QStringLiteral("Circle: midpoint");
    method.source = QStringLiteral("Rasterization slides, “Bresenham's Line Algorithm”, "
                                   "“Résumé” (adaptable to circles); Scan Conversion slides, "
                                   "“Lines and Curves: Implicit”");
    method.summary = QStringLiteral("Steps through an octant by the sign of F at midpoints, an "
                                    "integer, and mirrors each pixel into the other seven.");
    method.remarks += QStringLiteral("whole-pixel centre and radii");
    method.variants = {Variant::StayAtZero};
    return method;
}

Method circleFillMethod()
{
    Method method = outlineMethod<FillKernel>();
    method.id = QStringLiteral("circle-fill");
    method.title = QStringLiteral("Circle: filled by spans");
    method.source = QStringLiteral("Rasterization slides, “Output Primitives” (also filled); "
                                   "Scan Conversion slides, “Edge Walking”");
    method.summary = QStringLiteral("On each row, writes the samples between the two places where "
                                    "the row meets the curve.");
    method.stableArithmetics = {Arithmetic::Exact};
    method.fills = {ShapeFill::EvenOdd, ShapeFill::NonZero};
    return method;
}

Method bezierSubdivisionMethod()
{
    Method method = curveMethod<BezierKernel>();
    method.id = QStringLiteral("bezier-subdivision");
    method.title = QStringLiteral("Bézier: subdivision");
    method.source = QStringLiteral("Rasterization slides, “Output Primitives” (other curves); "
                                   "Scan Conversion slides, “Polygons” (splines)");
    method.summary = QStringLiteral("Halves the curve by de Casteljau's algorithm until each piece "
                                    "has no pixels but those of its two ends, and writes these: "
                                    "thin as a line, the pixels nearer than ½ px by |Δx| + |Δy|.");
    method.kinds = {PrimitiveKind::Bezier};
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

Method pointAddressMethod()
{
    Method method = curveMethod<PointKernel>();
    method.id = QStringLiteral("point-address");
    method.title = QStringLiteral("Points by address");
    method.family = MethodFamily::Others;
    method.source = QStringLiteral("Rasterization slides, “Point Plotting”");
    method.summary = QStringLiteral("Writes the colour of each point to the address "
                                    "addr = y·width + x.");
    method.kinds = {PrimitiveKind::Point};
    method.fillRuleReason = QStringLiteral("a point has no edges");
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

} // namespace pixelplumb
