// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/edgewalks.h"

#include "core/methods/edgewalkmethod.h"
#include "core/scan/biasarithmetic.h"
#include "core/scan/constantratearithmetic.h"

namespace pixelplumb {

namespace {

using RowWalk
    = EdgeWalkKernel<EdgeWalkTable{SpanAxis::Row, WalkForm::Accumulated, ColourRate::Bilinear}>;

struct ConstantRateScan
    : EdgeWalkKernel<EdgeWalkTable{SpanAxis::Column, WalkForm::Accumulated, ColourRate::Plane}> {
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth width,
                                      const Function &function)
    {
        return InAnyArithmetic::withNumbers(settings, width, [&]<class A>() {
            return function.template operator()<ConstantRateArithmetic<A>>();
        });
    }
};

struct BiasScan
    : EdgeWalkKernel<EdgeWalkTable{SpanAxis::Column, WalkForm::Direct, ColourRate::Plane}> {
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth width,
                                      const Function &function)
    {
        if (settings.arithmetic == Arithmetic::Float64)
            return function.template operator()<BiasArithmetic>();
        if (width == IntegerWidth::Bits64)
            return function.template operator()<ExactArithmetic<std::int64_t>>();
        return function.template operator()<ExactArithmetic<Int128>>();
    }
};

QString columnRuleReason()
{
    return QStringLiteral("a column ends at its two bounds whatever edge they belong to");
}

} // namespace

Method rowWalkMethod()
{
    Method method = edgeWalkMethod<RowWalk>();
    method.id = QStringLiteral("row-walk");
    method.title = QStringLiteral("Row edge walking");
    method.source = QStringLiteral("seed 002, slides “Edge Walking” and “Possible Cases”; seed "
                                   "003, slides “Edge Walking” and “Edge Walking Triangles”");
    method.summary
        = QStringLiteral("Walks down the rows between two edges, switches in the third edge at the "
                         "middle vertex, and colours the samples from ⌈x_L⌉ to ⌊x_R⌋, trapezoid "
                         "by trapezoid, all by adding increments.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::TopLeft};
    method.fillRuleReason
        = QStringLiteral("a row ends at its two bounds whatever edge they belong to");
    return method;
}

Method constantRateColumnScanMethod()
{
    Method method = edgeWalkMethod<ConstantRateScan>();
    method.id = QStringLiteral("column-scan-constant-rate");
    method.title = QStringLiteral("Column scan, constant ΔR");
    method.family = MethodFamily::StableForms;
    method.source = QStringLiteral("the stable form of seed 004, “Smoothly shading the triangle”, "
                                   "by the plane equation of seed 003");
    method.summary
        = QStringLiteral("The assignment's increments with ΔR computed once from the plane through "
                         "the three vertices, so that slivers cannot blow it up.");
    method.arithmetics.assign(allArithmetics.begin(), allArithmetics.end());
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn};
    method.fillRuleReason = columnRuleReason();
    return method;
}

Method biasColumnScanMethod()
{
    Method method = edgeWalkMethod<BiasScan>();
    method.id = QStringLiteral("column-scan-bias");
    method.title = QStringLiteral("Column scan, half-quantum bias");
    method.family = MethodFamily::StableForms;
    method.source = QStringLiteral("the stable form of seed 004 in float64");
    method.summary = QStringLiteral(
        "Computes y₀ + (x − x₀)·m and the plane's colours in float64 and moves "
        "them by half the distance between their possible values before rounding: "
        "no wrong pixel, proved up to W'·H' = 2^40 lattice units; beyond, integers "
        "take over and the set-up says so.");
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact, Arithmetic::Float64};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn};
    method.fillRuleReason = columnRuleReason();
    return method;
}

} // namespace pixelplumb
