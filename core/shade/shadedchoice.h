// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/shadedrun.h"

namespace pixelplumb {

/// The methods that draw effects.
enum class ShadedMethod : std::uint8_t { ColumnScan, Bilinear, Plane, Barycentric };

constexpr InterpolationForm formOf(ShadedMethod method)
{
    switch (method) {
    case ShadedMethod::Plane:
        return InterpolationForm::Plane;
    case ShadedMethod::Barycentric:
        return InterpolationForm::Barycentric;
    case ShadedMethod::ColumnScan:
    case ShadedMethod::Bilinear:
        break;
    }
    return InterpolationForm::Bilinear;
}

/// Whether the bounds of all triangles fit 64 bits, and the numbers for shading 128.
struct ShadingWidths {
    bool narrowBounds = true;
    bool narrowShading = true;
};
ShadingWidths shadingWidthsFor(const Primitives &primitives, const EffectPlan &plan);

/// Calls function.operator()<N, A>() with a method's number types: N for shading, A for the bounds.
/// The column scan walks its bounds in the arithmetic of the settings, the interpolations exactly.
template <class Function>
decltype(auto) withShadingNumbers(ShadedMethod method, const ScanSettings &settings,
                                  const ShadingWidths &widths, const Function &function)
{
    using NarrowBounds = ExactArithmetic<std::int64_t>;
    using WideBounds = ExactArithmetic<Int128>;
    if (settings.arithmetic == Arithmetic::Float32) {
        if (method == ShadedMethod::ColumnScan)
            return function.template operator()<FloatShading<float>, RoundedArithmetic<float>>();
        if (widths.narrowBounds)
            return function.template operator()<FloatShading<float>, NarrowBounds>();
        return function.template operator()<FloatShading<float>, WideBounds>();
    }
    if (settings.arithmetic == Arithmetic::Float64 && method != ShadedMethod::ColumnScan)
        return function.template operator()<FloatShading<double>, WideBounds>();
    if (widths.narrowBounds && widths.narrowShading)
        return function.template operator()<ExactShading<Int128>, NarrowBounds>();
    return function.template operator()<ExactShading<Int256>, WideBounds>();
}

/// The effects of each triangle, by its index.
class TriangleEffects {
public:
    explicit TriangleEffects(const EffectPlan &plan)
        : m_plan(plan)
    {
    }

    /// To be called in ascending order.
    const EffectSet &at(std::size_t triangle)
    {
        while (triangle >= m_plan.batches[m_batch].first + m_plan.batches[m_batch].count)
            ++m_batch;
        return m_plan.batches[m_batch].effects;
    }

private:
    const EffectPlan &m_plan;
    std::size_t m_batch = 0;
};

} // namespace pixelplumb
