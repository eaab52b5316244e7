// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves.h"

#include "core/methods/bezierrecording.h"
#include "core/methods/curvekernels.h"

namespace pixelplumb {

namespace {

struct BezierKernel : ShapeKernel<PrimitiveKind::Bezier>, InIntegers {
    template <class>
    using Recording = BezierRecording;

    static bool draws(const Primitives &primitives, std::size_t index)
    {
        return ShapeKernel::draws(primitives, index)
            && primitives.shape(index).fill == ShapeFill::Outline;
    }
    template <class, class Observer>
    static void scan(const Shape &shape, const ScanSettings &, FrameView frame, Observer observer)
    {
        BezierScan<Observer>(shape, frame, observer).run();
    }
};

/// The common part of this file's methods.
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
    method.pseudocode
        = {{0, QStringLiteral("(x_c, y_c), r_x, r_y ← of the shape"), {Moment::SetUp}},
           {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
           {0, QStringLiteral("for each column x of the curve:"), {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("h ← r_y/r_x·√(r_x² − (x − x_c)²)"), {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("pixel (x, ⌊y_c + h + ½⌋) ← colour"), {Moment::First}},
           {1,
            QStringLiteral("pixel (x, ⌈y_c − h − ½⌉) ← colour, where it is another one"),
            {Moment::Next}}};
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
    method.pseudocode
        = {{0, QStringLiteral("Δθ ← 1/r, one pixel of arc"), {Moment::SetUp}},
           {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
           {0, QStringLiteral("for i from 0, once around:"), {Moment::Begin, Moment::Span}},
           {1,
            QStringLiteral("θ ← i·Δθ, u ← x_c + r_x·cos θ, v ← y_c + r_y·sin θ"),
            {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("pixel (⌊u + ½⌋, ⌊v + ½⌋) ← colour"), {Moment::First}}};
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
    method.pseudocode
        = {{0, QStringLiteral("round the centre and the radii to whole pixels"), {Moment::SetUp}},
           {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
           {0,
            QStringLiteral("the start of an arc: x, y on it, p ← F at the midpoint next to it"),
            {Moment::Begin}},
           {0,
            QStringLiteral("for each x of the arc, with a step before each but the first:"),
            {Moment::Begin, Moment::Stay, Moment::Cross}},
           {1,
            QStringLiteral("if p ≤ 0, the midpoint is inside: y stays"),
            {Moment::Stay},
            {},
            {{VariantSet().with(Variant::StayAtZero),
              QStringLiteral("if p ≤ 0 (of equal radii p ≤ ¼, which a whole number takes for 0): y "
                             "stays")}}},
           {1, QStringLiteral("else: y goes inwards until it is, or y = 0"), {Moment::Cross}},
           {1,
            QStringLiteral("p ← F at the next midpoint, by adding Δp"),
            {Moment::Stay, Moment::Cross}},
           {1, QStringLiteral("pixel (x_c + x, y_c + y) ← colour"), {Moment::First}},
           {1, QStringLiteral("its mirror images ← colour"), {Moment::Next}}};
    method.summary
        = QStringLiteral("Steps through an octant by the sign of F at midpoints, a "
                         "whole number of quarters, and mirrors each pixel into the other seven; "
                         "of unequal radii through two arcs of a quarter, each into three.");
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
    method.pseudocode
        = {{0, QStringLiteral("(x_c, y_c), r_x, r_y ← of the shape"), {Moment::SetUp}},
           {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
           {0, QStringLiteral("for each row y of the shape:"), {Moment::Begin, Moment::Span}},
           {1,
            QStringLiteral("x_L, x_R ← where the row meets the curve"),
            {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("for each x from ⌈x_L⌉ to ⌊x_R⌋:"), {Moment::First, Moment::Next}},
           {2, QStringLiteral("pixel (x, y) ← colour"), {Moment::First, Moment::Next}}};
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
    method.pseudocode
        = {{0, QStringLiteral("piece ← the whole curve"), {Moment::SetUp}},
           {0, QStringLiteral("if no sample is to be drawn: done"), {Moment::Rejected}},
           {0,
            QStringLiteral("if more pixels than those of its ends may belong to the piece:"),
            {Moment::Halve}},
           {1,
            QStringLiteral(
                "halve it by de Casteljau and do this with the first half, then with the second"),
            {Moment::Halve}},
           {0,
            QStringLiteral("else: pixels ← those of its ends, and of a corner that it passes"),
            {Moment::Span}},
           {1,
            QStringLiteral("each pixel that was not the last one ← colour"),
            {Moment::First, Moment::Next}}};
    method.summary = QStringLiteral("Halves the curve by de Casteljau's algorithm until each piece "
                                    "has no pixels but those of its two ends, and writes these: "
                                    "thin as a line, the pixels nearer than ½ px by |Δx| + |Δy|.");
    method.kinds = {PrimitiveKind::Bezier};
    method.fills = {ShapeFill::Outline};
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
    method.pseudocode
        = {{0, QStringLiteral("points ← those of the shape"), {Moment::SetUp}},
           {0, QStringLiteral("if none is in the frame: done"), {Moment::Rejected}},
           {0, QStringLiteral("for each point:"), {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("(x, y) ← the nearest pixel"), {Moment::Begin, Moment::Span}},
           {1,
            QStringLiteral("if it is in the frame: addr ← (y − y₀)·width + (x − x₀) — (x₀, y₀) is "
                           "the frame's first pixel"),
            {Moment::Begin, Moment::Span}},
           {1, QStringLiteral("frame[addr] ← colour"), {Moment::First}}};
    method.summary = QStringLiteral("Writes the colour of each point to the address "
                                    "addr = y·width + x, counted from the frame's first pixel.");
    method.kinds = {PrimitiveKind::Point};
    method.fillRuleReason = QStringLiteral("a point has no edges");
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

} // namespace pixelplumb
