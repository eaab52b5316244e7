// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves.h"

#include "core/methods/bezierrecording.h"
#include "core/methods/circlerecording.h"
#include "core/methods/curvecolumns.h"
#include "core/methods/kernelmethod.h"
#include "core/methods/pointrecording.h"

namespace pixelplumb {

namespace {

using RoundKernel = ShapeKernel<PrimitiveKind::Circle, PrimitiveKind::Ellipse>;

struct OutlineKernel : RoundKernel {
    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return RoundKernel::draws(primitives, index)
            && primitives.shape(index).fill == ShapeFill::Outline;
    }
};

struct ExplicitKernel
    : OutlineKernel,
      InExactOrFloat<ExactArithmetic<Int128>, RoundedArithmetic<float>, RoundedArithmetic<double>> {
    template <class A>
    using Recording = CircleExplicitRecording<A>;

    template <class A, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        scanCircleExplicitly<A>(shape, frame, observer);
    }
};

/// It has no exact numbers: double is the nearest to them.
struct ParametricKernel : OutlineKernel, InExactOrFloat<double, float, double> {
    template <class Float>
    using Recording = CircleParametricRecording<Float>;

    template <class Float, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        scanCircleParametrically<Float>(shape, frame, observer);
    }
};

struct MidpointKernel : OutlineKernel, InIntegers {
    template <class>
    using Recording = MidpointRecording;

    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        scanCircleByMidpoint(shape, frame, observer);
    }
};

struct FillKernel : RoundKernel, InIntegers {
    template <class>
    using Recording = CircleFillRecording;

    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return RoundKernel::draws(primitives, index)
            && primitives.shape(index).fill != ShapeFill::Outline;
    }
    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        fillCircle(shape, frame, observer);
    }
};

struct BezierKernel : ShapeKernel<PrimitiveKind::Bezier>, InIntegers {
    template <class>
    using Recording = BezierRecording;

    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        BezierScan<Observer>(shape, frame, observer).run();
    }
};

struct PointKernel : ShapeKernel<PrimitiveKind::Point>, InIntegers {
    template <class>
    using Recording = PointRecording;

    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        plotPoints(shape, frame, observer);
    }
};

/// What the methods of this file have in common.
template <class Kernel>
Method curveMethod()
{
    Method method;
    method.family = MethodFamily::Curves;
    method.effects = {QStringLiteral("one colour"), QStringLiteral("clipping to the frame")};
    method.arithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed};
    method.fillRuleReason = QStringLiteral("a curve has no edges that two shapes could share");
    method.draw = drawWith<Kernel>;
    method.trace = traceWith<Kernel>;
    return method;
}

template <class Kernel>
Method outlineMethod()
{
    Method method = curveMethod<Kernel>();
    method.kinds = {PrimitiveKind::Circle, PrimitiveKind::Ellipse};
    method.fills = {ShapeFill::Outline};
    method.setUpColumns = roundSetUpColumns();
    return method;
}

} // namespace

Method circleExplicitMethod()
{
    Method method = outlineMethod<ExplicitKernel>();
    method.id = QStringLiteral("circle-explicit");
    method.title = QStringLiteral("Circle: y = ±√(r² − x²)");
    method.source = QStringLiteral("seed 003, slide “Lines and Curves: Explicit”");
    method.summary = QStringLiteral("Computes y = ±√(r² − x²) for each column; there are gaps "
                                    "where the curve is steep.");
    method.effects += QStringLiteral("gaps where the curve is steep");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.spanColumns = circleExplicitColumns();
    return method;
}

Method circleParametricMethod()
{
    Method method = outlineMethod<ParametricKernel>();
    method.id = QStringLiteral("circle-parametric");
    method.title = QStringLiteral("Circle: (r cos θ, r sin θ)");
    method.source = QStringLiteral("seed 003, slide “Lines and Curves: Parametric”");
    method.summary = QStringLiteral("Goes round in steps of one pixel of arc and writes the pixel "
                                    "nearest to each point (r cos θ, r sin θ).");
    method.arithmetics = {Arithmetic::Float64, Arithmetic::Float32};
    method.setUpColumns = circleParametricSetUpColumns();
    method.spanColumns = circleParametricColumns();
    return method;
}

Method circleMidpointMethod()
{
    Method method = outlineMethod<MidpointKernel>();
    method.id = QStringLiteral("circle-midpoint");
    method.title = QStringLiteral("Circle: midpoint");
    method.source = QStringLiteral("seed 002, “Bresenham's Line Algorithm: Résumé” (adaptable to "
                                   "circles); seed 003, “Lines and Curves: Implicit”");
    method.summary = QStringLiteral("Steps through an octant by the sign of F at midpoints, an "
                                    "integer, and mirrors each pixel into the other seven.");
    method.effects += QStringLiteral("whole-pixel centre and radii");
    method.spanColumns = circleMidpointColumns();
    return method;
}

Method circleFillMethod()
{
    Method method = outlineMethod<FillKernel>();
    method.id = QStringLiteral("circle-fill");
    method.title = QStringLiteral("Circle: filled by spans");
    method.source = QStringLiteral("seed 002, “Output Primitives” (also filled); seed 003, “Edge "
                                   "Walking”");
    method.summary = QStringLiteral("On each row, writes the samples between the two places where "
                                    "the row meets the curve.");
    method.stableArithmetics = {Arithmetic::Exact};
    method.fills = {ShapeFill::EvenOdd, ShapeFill::NonZero};
    method.spanColumns = circleFillColumns();
    return method;
}

Method bezierSubdivisionMethod()
{
    Method method = curveMethod<BezierKernel>();
    method.id = QStringLiteral("bezier-subdivision");
    method.title = QStringLiteral("Bézier: subdivision");
    method.source = QStringLiteral("seed 002, “Output Primitives” (other curves); seed 003, "
                                   "“Polygons” (splines)");
    method.summary = QStringLiteral("Halves the curve by de Casteljau's algorithm until each piece "
                                    "is flat, and draws the pieces as lines.");
    method.kinds = {PrimitiveKind::Bezier};
    method.effects += QStringLiteral("whole-pixel ends of the pieces");
    method.setUpColumns = bezierSetUpColumns();
    method.spanColumns = bezierColumns();
    return method;
}

Method pointAddressMethod()
{
    Method method = curveMethod<PointKernel>();
    method.id = QStringLiteral("point-address");
    method.title = QStringLiteral("Points by address");
    method.family = MethodFamily::Others;
    method.source = QStringLiteral("seed 002, slide “Point Plotting”");
    method.summary = QStringLiteral("Writes the colour of each point to the address "
                                    "addr = y·width + x.");
    method.kinds = {PrimitiveKind::Point};
    method.fillRuleReason = QStringLiteral("a point has no edges");
    method.stableArithmetics = {Arithmetic::Exact};
    method.setUpColumns = pointSetUpColumns();
    method.spanColumns = pointColumns();
    return method;
}

} // namespace pixelplumb
