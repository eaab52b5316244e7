// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/curves/bezierrecording.h"
#include "core/methods/curves/curvekernels.h"
#include "core/methods/methodrows.h"

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
    method.fillRuleReason = "a curve has no edges that two shapes could share";
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

/// F(x, y) = B·x² + A·y² − A·b² is 0 on the arc; of equal radii it is divided by r².
Pseudocode midpointPseudocode()
{
    using enum Moment;
    const VariantSet staying = VariantSet().with(Variant::StayAtZero);
    return {{0, "x_c, y_c, r_x, r_y ← ⌊x_c + ½⌋, ⌊y_c + ½⌋, ⌊r_x + ½⌋, ⌊r_y + ½⌋", {SetUp}},
            {0, "if no sample is to be drawn: done", {Rejected}},
            {0, "for each arc (a, b) of (r_x, r_y) and, if r_x ≠ r_y, (r_y, r_x):", {Begin}},
            {1,
             "A, B ← a², b² if a ≠ b, else 1, 1",
             {Begin},
             {},
             {{staying,
               "A, B, most ← a², b², 0 if a ≠ b, else 1, 1, ¼ — of equal radii a whole number "
               "takes p = ¼ for 0"}}},
            {1, "for each x from 0 to ⌊a²/√(a² + b²) + ½⌋ if a > 0, else 0:", {Begin, Stay, Cross}},
            {2, "the first: y, p ← b, B + A·(b − ½)² − A·b² — F at the first midpoint", {Begin}},
            {2,
             "else if p ≤ 0: p ← p + B·(2x + 1) — the midpoint is inside: y stays",
             {Stay},
             {},
             {{staying, "else if p ≤ most: p ← p + B·(2x + 1)"}}},
            {2, "else:", {Cross}},
            {3,
             "while p > 0 and y > 0: y, p ← y − 1, p − 2A·(y − 1)",
             {Cross},
             {},
             {{staying, "while p > most and y > 0: y, p ← y − 1, p − 2A·(y − 1)"}}},
            {3, "p ← p + B·(2x + 1)", {Cross}},
            {2, "if a = r_x: pixel (x_c ± x, y_c ± y) ← colour", {First, Next}},
            {2, "if a = r_y: pixel (x_c ± y, y_c ± x) ← colour", {First, Next}}};
}

} // namespace

Method circleExplicitMethod()
{
    Method method = outlineMethod<ExplicitKernel>();
    method.id = "circle-explicit";
    method.title = QT_TRANSLATE_NOOP("core", "Circle: y = ±√(r² − x²)");
    method.source = "Scan Conversion slides, “Lines and Curves: Explicit”";
    method.pseudocode = {
        {0, "given: x_c, y_c, r_x, r_y of the shape", {Moment::SetUp}},
        {0, "if no sample is to be drawn: done", {Moment::Rejected}},
        {0, "for each column x from ⌈x_c − r_x⌉ to ⌊x_c + r_x⌋:", {Moment::Begin, Moment::Span}},
        {1, "h ← r_y/r_x·√(r_x² − (x − x_c)²) if r_x > 0, else r_y", {Moment::Begin, Moment::Span}},
        {1, "pixel (x, ⌊y_c + h + ½⌋) ← colour", {Moment::First}},
        {1, "pixel (x, ⌈y_c − h − ½⌉) ← colour — the same one at the ends", {Moment::Next}}};
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Computes y = ±√(r² − x²) for each column; there are gaps where the curve is steep.");
    method.remarks += u"gaps where the curve is steep"_s;
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    return method;
}

Method circleParametricMethod()
{
    Method method = outlineMethod<ParametricKernel>();
    method.id = "circle-parametric";
    method.title = QT_TRANSLATE_NOOP("core", "Circle: (r cos θ, r sin θ)");
    method.source = "Scan Conversion slides, “Lines and Curves: Parametric”";
    method.pseudocode
        = {{0,
            "r ← r_x if r_x ≥ r_y, else r_y; Δθ ← 1/r if r > 0, else 0 — one pixel of arc",
            {Moment::SetUp}},
           {0, "if no sample is to be drawn: done", {Moment::Rejected}},
           {0, "for each i from 0 to ⌈2π·r⌉ − 1 if r > 0, else 0:", {Moment::Begin, Moment::Span}},
           {1, "θ ← i·Δθ; u, v ← x_c + r_x·cos θ, y_c + r_y·sin θ", {Moment::Begin, Moment::Span}},
           {1, "pixel (⌊u + ½⌋, ⌊v + ½⌋) ← colour", {Moment::First}}};
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Goes round in steps of one pixel of arc and writes the "
                                       "pixel nearest to each point (r cos θ, r sin θ).");
    method.arithmetics = {Arithmetic::Float64, Arithmetic::Float32};
    return method;
}

Method circleMidpointMethod()
{
    Method method = outlineMethod<MidpointKernel>();
    method.id = "circle-midpoint";
    method.title = QT_TRANSLATE_NOOP("core", "Circle: midpoint");
    method.source = "Rasterization slides, “Bresenham's Line Algorithm”, “Résumé” (adaptable to "
                    "circles); Scan Conversion slides, “Lines and Curves: Implicit”";
    method.pseudocode = midpointPseudocode();
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Steps through an octant by the sign of F at midpoints, a whole number "
                            "of quarters, and mirrors each pixel into the other seven; of unequal "
                            "radii through two arcs of a quarter, each into three.");
    method.remarks += u"whole-pixel centre and radii"_s;
    method.roundsPoints = true;
    method.variants = {Variant::StayAtZero};
    return method;
}

Method circleFillMethod()
{
    Method method = outlineMethod<FillKernel>();
    method.id = "circle-fill";
    method.title = QT_TRANSLATE_NOOP("core", "Circle: filled by spans");
    method.source = "Rasterization slides, “Output Primitives” (also filled); Scan Conversion "
                    "slides, “Edge Walking”";
    method.pseudocode
        = {{0, "given: x_c, y_c, r_x, r_y of the shape", {Moment::SetUp}},
           {0, "if no sample is to be drawn: done", {Moment::Rejected}},
           {0, "for each row y from ⌈y_c − r_y⌉ to ⌊y_c + r_y⌋:", {Moment::Begin, Moment::Span}},
           {1,
            "h ← r_x/r_y·√(r_y² − (y − y_c)²) if r_y > 0, else r_x; x_L, x_R ← x_c − h, x_c + h",
            {Moment::Begin, Moment::Span}},
           {1, "for each x from ⌈x_L⌉ to ⌊x_R⌋:", {Moment::First, Moment::Next}},
           {2, "pixel (x, y) ← colour", {Moment::First, Moment::Next}}};
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "On each row, writes the samples between the two places where the row meets the curve.");
    method.stableArithmetics = {Arithmetic::Exact};
    method.fills = {ShapeFill::EvenOdd, ShapeFill::NonZero};
    return method;
}

Method bezierSubdivisionMethod()
{
    Method method = curveMethod<BezierKernel>();
    method.id = "bezier-subdivision";
    method.title = QT_TRANSLATE_NOOP("core", "Bézier: subdivision");
    method.source = "Rasterization slides, “Output Primitives” (other curves); Scan Conversion "
                    "slides, “Polygons” (splines)";
    method.pseudocode = {
        {0,
         "given: undecided(d, k), 1 where the piece from t = k/2ᵈ to t = (k + 1)/2ᵈ may have more "
         "pixels than those of its ends, else 0",
         {Moment::SetUp}},
        {0,
         "given: first(d, k), corner(d, k), last(d, k), the pixels of its two ends, and of a "
         "corner that it passes, or places beyond the frame",
         {Moment::SetUp}},
        {0, "d, k ← 0, 0 — the whole curve", {Moment::SetUp}},
        {0, "if no sample is to be drawn: done", {Moment::Rejected}},
        {0, "while k = 0, or d > 0:", {Moment::Halve, Moment::Span}},
        {1, "s ← undecided(d, k)", {Moment::Halve, Moment::Span}},
        {1,
         "if s = 1: d, k ← d + 1, 2·k — halve it by de Casteljau, and do this with the first half",
         {Moment::Halve}},
        {1, "else:", {Moment::Span}},
        {2, "x, y ← first(d, k)", {Moment::Span}},
        {2,
         "pixel (x, y) ← colour — a pixel that was the last one, too, is not written again",
         {Moment::First, Moment::Next}},
        {2, "x, y ← corner(d, k)", {Moment::Span}},
        {2, "pixel (x, y) ← colour", {Moment::First, Moment::Next}},
        {2, "x, y ← last(d, k)", {Moment::Span}},
        {2, "pixel (x, y) ← colour", {Moment::First, Moment::Next}},
        {2, "k ← k + 1", {Moment::Span}},
        {2,
         "while k mod 2 = 0 and d > 0: d, k ← d − 1, k/2 — both halves are done",
         {Moment::Span}}};
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Halves the curve by de Casteljau's algorithm until each piece has no "
                            "pixels but those of its two ends, and writes these: thin as a line, "
                            "the pixels nearer than ½ px by |Δx| + |Δy|.");
    method.kinds = {PrimitiveKind::Bezier};
    method.fills = {ShapeFill::Outline};
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

Method pointAddressMethod()
{
    Method method = curveMethod<PointKernel>();
    method.id = "point-address";
    method.title = QT_TRANSLATE_NOOP("core", "Points by address");
    method.family = MethodFamily::Others;
    method.source = "Rasterization slides, “Point Plotting”";
    method.pseudocode = {
        {0, "given: the points of the shape", {Moment::SetUp}},
        {0, "if none is in the frame: done", {Moment::Rejected}},
        {0, "for each point (x, y):", {Moment::Begin, Moment::Span}},
        {1, "x, y ← ⌊x + ½⌋, ⌊y + ½⌋", {Moment::Begin, Moment::Span}},
        {1,
         "if x₀ ≤ x < x₀ + width and y₀ ≤ y < y₀ + height: — (x₀, y₀) is the frame's first pixel",
         {Moment::Begin, Moment::Span}},
        {2, "addr ← (y − y₀)·width + (x − x₀)", {Moment::First}},
        {2, "frame[addr] ← colour", {Moment::First}}};
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Writes the colour of each point to the address addr = "
                                       "y·width + x, counted from the frame's first pixel.");
    method.kinds = {PrimitiveKind::Point};
    method.fillRuleReason = "a point has no edges";
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

} // namespace pixelplumb
