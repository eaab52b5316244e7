// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/lines/linekernels.h"
#include "core/methods/lines/linemethod.h"
#include "core/methods/methodrows.h"

namespace pixelplumb {

namespace {

// What the listings begin with. Every line of it is run by tst_listings.

PseudocodeLine exchangeIfSteep()
{
    return {0,
            "if |y₁ − y₀| ≥ |x₁ − x₀|: exchange x and y, here and where a pixel is written",
            {Moment::SetUp}};
}

/// With their colours.
PseudocodeLine exchangeEnds() { return {0, "if x₁ < x₀: exchange the ends", {Moment::SetUp}}; }

PseudocodeLine deltas()
{
    return {0, "Δx, Δy ← x₁ − x₀, |y₁ − y₀|; s ← 1 if y₀ ≤ y₁, else −1", {Moment::SetUp}};
}

PseudocodeLine noneDrawn() { return {0, "if no sample is to be drawn: done", {Moment::Rejected}}; }

} // namespace

Method lineSlopeInterceptMethod()
{
    Method method = lineMethod<SlopeInterceptKernel>();
    method.id = "line-slope-intercept";
    method.title = QT_TRANSLATE_NOOP("core", "Line: y = m·x + b");
    method.source = "Rasterization slides, “Line-Drawing Algorithms” and “Example”; Scan "
                    "Conversion slides, “Lines and Curves: Explicit”";
    method.pseudocode = {exchangeEnds(),
                         {0, "if x₀ = x₁: done — it is vertical or a point", {Moment::Rejected}},
                         {0, "m ← (y₁ − y₀)/(x₁ − x₀); b ← y₀ − m·x₀", {Moment::SetUp}},
                         noneDrawn(),
                         {0, "for each column x from ⌈x₀⌉ to ⌊x₁⌋:", {Moment::Begin, Moment::Span}},
                         {1, "y ← m·x + b", {Moment::Begin, Moment::Span}},
                         {1,
                          "R ← R₀ + (x − x₀)·((R₁ − R₀)/(x₁ − x₀)); G and B likewise",
                          {Moment::Begin, Moment::Span}},
                         {1, "pixel (x, (int)(y + ½)) ← the bytes of R, G, B", {Moment::First}}};
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Computes y = m·x + b for each column and rounds it by "
                                       "(int)(y + ½): steep lines have gaps, vertical ones no m.");
    method.remarks += u"gaps where |m| > 1"_s;
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    return method;
}

Method lineParametricMethod()
{
    Method method = lineMethod<ParametricLineKernel>();
    method.id = "line-parametric";
    method.title = QT_TRANSLATE_NOOP("core", "Line: P(t)");
    method.source = "Scan Conversion slides, “Lines and Curves: Parametric”";
    const VariantSet twice = VariantSet().with(Variant::TwiceT);
    const VariantSet five = VariantSet().with(Variant::FiveT);
    const VariantSet both = twice.with(Variant::FiveT);
    const QString range = "for each t = i/N from 0 to 1/%1:";
    const QString point = "u, v ← x₀ + %1i·((x₁ − x₀)/N), y₀ + %1i·((y₁ − y₀)/N); R ← R₀ + "
                          "%1i·((R₁ − R₀)/N); G and B likewise";
    method.pseudocode = {{0, "N ← ⌈max(|x₁ − x₀|, |y₁ − y₀|, 1)⌉", {Moment::SetUp}},
                         noneDrawn(),
                         {0,
                          "for each t = i/N from 0 to 1:",
                          {Moment::Begin, Moment::Span},
                          {},
                          {{twice, range.arg(QChar(u'2'))},
                           {five, range.arg(QChar(u'5'))},
                           {both, range.arg("10")}}},
                         {1,
                          point.arg(QString()),
                          {Moment::Begin, Moment::Span},
                          {},
                          {{twice, point.arg(QChar(u'2'))},
                           {five, point.arg(QChar(u'5'))},
                           {both, point.arg("10")}}},
                         {1, "pixel (⌊u + ½⌋, ⌊v + ½⌋) ← the bytes of R, G, B", {Moment::First}}};
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Computes P(t) = P₀ + t·(P₁ − P₀) for t in steps of one pixel of the "
                            "longer side, or less, and writes the pixel nearest to each point.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.variants = {Variant::TwiceT, Variant::FiveT};
    return method;
}

Method lineDdaMethod()
{
    Method method = lineMethod<DdaKernel>();
    method.id = "line-dda";
    method.title = QT_TRANSLATE_NOOP("core", "Line: DDA");
    method.source = "Rasterization slides, “DDA Line-Drawing Algorithm”";
    const QString rates = "m ← Δv/%1; ΔR ← (R₁ − R₀)/%1; ΔG and ΔB likewise";
    const QString ratesIf
        = "m ← Δv/%1 if %2, else 0; ΔR ← (R₁ − R₀)/%1 if %2, else 0; ΔG and ΔB likewise";
    method.pseudocode
        = {exchangeIfSteep(),
           exchangeEnds(),
           {0, "u₀, v₀, u₁, v₁ ← x₀, y₀, x₁, y₁; Δu, Δv ← u₁ − u₀, v₁ − v₀", {Moment::SetUp}},
           {0,
            ratesIf.arg("Δu", "Δu > 0"),
            {Moment::SetUp},
            {},
            {{VariantSet().with(Variant::DivisorPlusOne), rates.arg("(Δu + 1)")},
             {VariantSet().with(Variant::DivisorMinusOne), ratesIf.arg("(Δu − 1)", "Δu > 1")},
             {VariantSet().with(Variant::DivisorPlusOne).with(Variant::DivisorMinusOne),
              rates.arg("max(Δu, 1)")}}},
           noneDrawn(),
           {0, "for each u of the frame from ⌈u₀⌉ to ⌊u₁⌋:", {Moment::Begin, Moment::Span}},
           {1,
            "the first: v ← v₀ + (u − u₀)·m; R ← R₀ + (u − u₀)·ΔR; G and B likewise",
            {Moment::Begin},
            {},
            {{VariantSet().with(Variant::NoEdgePreStep),
              "the first: v ← v₀ + (u − ⌈u₀⌉)·m; R ← R₀ + (u − ⌈u₀⌉)·ΔR; G and B likewise"}}},
           {1, "else: v ← v + m; R ← R + ΔR; G and B likewise", {Moment::Span}},
           {1, "pixel (u, ⌊v + ½⌋) ← the bytes of R, G, B", {Moment::First}}};
    method.summary = QT_TRANSLATE_NOOP("core",
                                       "Walks along the longer side and adds the slope at each "
                                       "step; the pixel is the nearest one.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.variants = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne};
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

Method lineBresenhamMethod()
{
    Method method = lineMethod<BresenhamKernel>();
    method.id = "line-bresenham";
    method.title = QT_TRANSLATE_NOOP("core", "Line: Bresenham");
    method.source = "Rasterization slides, “Bresenham's Line Algorithm (1/4)” to “(4/4)” and "
                    "“Bresenham: Example”";
    method.pseudocode
        = {{0, "x₀, y₀, x₁, y₁ ← ⌊x₀ + ½⌋, ⌊y₀ + ½⌋, ⌊x₁ + ½⌋, ⌊y₁ + ½⌋", {Moment::SetUp}},
           exchangeIfSteep(),
           exchangeEnds(),
           deltas(),
           noneDrawn(),
           {0,
            "for each x from x₀ to x₁:",
            {Moment::Begin},
            {},
            {{VariantSet().with(Variant::OneStepShort),
              "for each x from x₀ to x₁ − 1 if Δx > 0, else x₁:"}}},
           {1, "the first: y, p ← y₀, 2Δy − Δx", {Moment::Begin}},
           {1,
            "else if p < 0: p ← p + 2Δy",
            {Moment::Stay},
            {},
            {{VariantSet().with(Variant::StayAtZero), "else if p ≤ 0: p ← p + 2Δy"}}},
           {1, "else: y ← y + s; p ← p + 2Δy − 2Δx", {Moment::Cross}},
           coloursAlongLine(),
           {1, "pixel (x, y) ← the bytes of R, G, B", {Moment::First}}};
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Steps from the end of smaller x (of a steep line, of smaller y) by "
                            "the sign of an integer; p_k < 0 stays, so that a tie steps across.");
    method.remarks += u"whole-pixel end points"_s;
    method.roundsPoints = true;
    method.variants = {Variant::StayAtZero, Variant::OneStepShort};
    return method;
}

Method lineSymmetricMethod()
{
    Method method = lineMethod<SymmetricKernel>();
    method.id = "line-bresenham-symmetric";
    method.title = QT_TRANSLATE_NOOP("core", "Line: Bresenham, sub-pixel ends");
    method.source = "stable form of the Rasterization slides, “Bresenham's Line Algorithm”";
    method.pseudocode
        = {exchangeIfSteep(),
           exchangeEnds(),
           deltas(),
           {0, "m ← s·Δy/Δx if Δx > 0, else 0", {Moment::SetUp}},
           noneDrawn(),
           {0, "for each x from ⌈x₀⌉ to ⌊x₁⌋:", {Moment::Begin}},
           {1,
            "the first: y ← ⌊y₀ + (x − x₀)·m + ½⌋; p ← Δx·(2·s·(y₀ + (x + 1 − x₀)·m − y) − 1)",
            {Moment::Begin}},
           {1, "else if p < 0, or p = 0 and s < 0: p ← p + 2Δy", {Moment::Stay}},
           {1, "else: y ← y + s; p ← p + 2Δy − 2Δx", {Moment::Cross}},
           coloursAlongLine(),
           {1, "pixel (x, y) ← the bytes of R, G, B", {Moment::First}}};
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "Bresenham's decisions from any lattice point to any other, ties to "
                            "the pixel of larger y or x whether the line rises or falls.");
    method.stableArithmetics = {Arithmetic::Exact};
    return method;
}

} // namespace pixelplumb
