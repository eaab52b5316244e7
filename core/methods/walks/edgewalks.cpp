// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/methodrows.h"
#include "core/methods/walks/edgewalktraces.h"

namespace pixelplumb {

Method rowWalkMethod()
{
    Method method = edgeWalkMethod<RowWalk>();
    method.id = "row-walk";
    method.title = QT_TRANSLATE_NOOP("core", "Row edge walking");
    method.source = "Rasterization slides, “Edge Walking” and “Possible Cases”; Scan Conversion "
                    "slides, “Edge Walking” and “Edge Walking Triangles”";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Walks the rows between two edges, the largest y first, switches in the third edge at the "
        "middle vertex, and colours the samples from x_L to x_R that the fill rule takes, "
        "trapezoid by trapezoid, all by adding increments.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.variants = edgeWalkVariants();
    method.draw = drawVaried<drawWith<RowWalk>, drawWith<VariedRowWalk>>;
    method.trace = traceVaried<traceWith<RowWalk>, VariedRowWalk>;
    method.fillRules = {FillRule::Closed, FillRule::TopLeft, FillRule::Open};
    return method;
}

Method constantRateColumnScanMethod()
{
    Method method = edgeWalkMethod<ConstantRateWalk<SpanAxis::Column>>();
    method.id = "column-scan-constant-rate";
    method.title = QT_TRANSLATE_NOOP("core", "Column scan, constant ΔR");
    method.family = MethodFamily::StableForms;
    method.source = "stable form of the Assignment (Borst), “Smoothly shading the triangle”, by "
                    "the Scan Conversion slides, “2. Plane Equation”";
    method.summary
        = QT_TRANSLATE_NOOP("core",
                            "The assignment's increments with ΔR computed once from the plane "
                            "through the three vertices, so that slivers cannot blow it up.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};
    return method;
}

Method biasColumnScanMethod()
{
    Method method = edgeWalkMethod<BiasScan>();
    method.id = "column-scan-bias";
    method.title = QT_TRANSLATE_NOOP("core", "Column scan, half-quantum bias");
    method.family = MethodFamily::StableForms;
    method.source = "stable form of the Assignment (Borst) in float64";
    method.summary = QT_TRANSLATE_NOOP(
        "core",
        "Computes y₀ + (x − x₀)·m and the plane's colours in float64 and moves them by half the "
        "distance between their possible values before rounding: no wrong pixel, proved for "
        "triangles in boxes of up to 2^24 px², such as 4096 × 4096; beyond, integers take over and "
        "the set-up says so.");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact, Arithmetic::Float64};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};
    return method;
}

} // namespace pixelplumb
