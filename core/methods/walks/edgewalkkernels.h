// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/variededgewalk.h"
#include "core/scan/biasarithmetic.h"
#include "core/scan/constantratearithmetic.h"

/// The kernels of the edge walks in the form that kernelmethod.h requires.
namespace pixelplumb {

template <SpanAxis axis>
inline constexpr EdgeWalkForm literalWalk = {axis, WalkForm::Accumulated, ColourRate::Bilinear};

using ColumnScanKernel = EdgeWalkKernel<literalWalk<SpanAxis::Column>>;
using VariedColumnScan = VariedEdgeWalkKernel<literalWalk<SpanAxis::Column>>;

using RowWalk = EdgeWalkKernel<literalWalk<SpanAxis::Row>>;
using VariedRowWalk = VariedEdgeWalkKernel<literalWalk<SpanAxis::Row>>;

template <SpanAxis axis>
struct ConstantRateWalk
    : EdgeWalkKernel<EdgeWalkForm{axis, WalkForm::Accumulated, ColourRate::Plane}> {
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
    : EdgeWalkKernel<EdgeWalkForm{SpanAxis::Column, WalkForm::Direct, ColourRate::Plane}> {
    /// The narrow case also needs the domain in which the bias is proved.
    static IntegerWidth widthFor(const Triangle &triangle, const FrameView &)
    {
        const bool isNarrow = integerWidthFor(triangle) == IntegerWidth::Bits64;
        return isNarrow && biasdomain::containsNarrow(triangle) ? IntegerWidth::Bits64
                                                                : IntegerWidth::Bits128;
    }
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth width,
                                      const Function &function)
    {
        const bool isNarrow = width == IntegerWidth::Bits64;
        if (settings.arithmetic == Arithmetic::Float64) {
            if (isNarrow)
                return function.template operator()<BiasArithmetic<BiasNumber>>();
            return function.template operator()<BiasArithmetic<BiasOrExactNumber>>();
        }
        if (isNarrow)
            return function.template operator()<ExactArithmetic<std::int64_t>>();
        return function.template operator()<ExactArithmetic<Int128>>();
    }
};

} // namespace pixelplumb
