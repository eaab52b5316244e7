// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scansettings.h"

#include <algorithm>
#include <span>

namespace pixelplumb {

/// Calls a template with the arithmetic's type: the one switch over arithmetics.
template <class Function>
decltype(auto) withArithmetic(Arithmetic arithmetic, IntegerWidth width, const Function &function)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        break;
    case Arithmetic::Float32:
        return function.template operator()<RoundedArithmetic<float>>();
    case Arithmetic::Float64:
        return function.template operator()<RoundedArithmetic<double>>();
    case Arithmetic::Fixed16:
        return function.template operator()<RoundedArithmetic<FixedPoint16>>();
    case Arithmetic::Fixed32:
        return function.template operator()<RoundedArithmetic<FixedPoint32>>();
    }
    if (width == IntegerWidth::Bits64)
        return function.template operator()<ExactArithmetic<std::int64_t>>();
    return function.template operator()<ExactArithmetic<Int128>>();
}

/// One trace has one number type: 128 bits as soon as one triangle needs them. The numbers are the
/// same.
inline IntegerWidth widestOf(std::span<const Triangle> triangles)
{
    const bool wide = std::ranges::any_of(triangles, [](const Triangle &triangle) {
        return integerWidthFor(triangle) == IntegerWidth::Bits128;
    });
    return wide ? IntegerWidth::Bits128 : IntegerWidth::Bits64;
}

} // namespace pixelplumb
