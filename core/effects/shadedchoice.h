// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/shadedrun.h"

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

/// Calls function.operator()<method>().
template <class Function>
decltype(auto) withShadedMethod(ShadedMethod method, const Function &function)
{
    switch (method) {
    case ShadedMethod::Plane:
        return function.template operator()<ShadedMethod::Plane>();
    case ShadedMethod::Barycentric:
        return function.template operator()<ShadedMethod::Barycentric>();
    case ShadedMethod::Bilinear:
        return function.template operator()<ShadedMethod::Bilinear>();
    case ShadedMethod::ColumnScan:
        break;
    }
    return function.template operator()<ShadedMethod::ColumnScan>();
}

/// Whether 64 bits hold the bounds of all triangles, and 128 what they are shaded from.
struct ShadingWidths {
    bool narrowBounds = true;
    bool narrowShading = true;
};
ShadingWidths shadingWidthsFor(const Primitives &primitives, const EffectPlan &plan);

/// Calls function.operator()<Form, N, A>() with the numbers that a method computes in: N of what is
/// shaded, A of the bounds. The column scan walks its bounds in the arithmetic of the settings, the
/// interpolations exactly.
template <ShadedMethod method, class Function>
decltype(auto) withShadingNumbers(const ScanSettings &settings, const ShadingWidths &widths,
                                  const Function &function)
{
    constexpr InterpolationForm Form = formOf(method);
    using NarrowBounds = ExactArithmetic<std::int64_t>;
    using WideBounds = ExactArithmetic<Int128>;
    if (settings.arithmetic == Arithmetic::Float32) {
        if constexpr (method == ShadedMethod::ColumnScan)
            return function
                .template operator()<Form, FloatShading<float>, RoundedArithmetic<float>>();
        else if (widths.narrowBounds)
            return function.template operator()<Form, FloatShading<float>, NarrowBounds>();
        else
            return function.template operator()<Form, FloatShading<float>, WideBounds>();
    }
    if constexpr (method != ShadedMethod::ColumnScan) {
        if (settings.arithmetic == Arithmetic::Float64)
            return function.template operator()<Form, FloatShading<double>, WideBounds>();
    }
    if (widths.narrowBounds && widths.narrowShading)
        return function.template operator()<Form, ExactShading<Int128>, NarrowBounds>();
    return function.template operator()<Form, ExactShading<Int256>, WideBounds>();
}

/// The effects of each triangle, by its index.
class TriangleEffects {
public:
    explicit TriangleEffects(const EffectPlan &plan)
        : m_plan(plan)
    {
    }

    /// Asked in ascending order.
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
