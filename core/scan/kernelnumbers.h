// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/scan/exactarithmetic.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/scansettings.h"

/// The numbers that kernels compute in. Each of these parts of a kernel (see kernelmethod.h) says
/// which integers hold the exact products of one primitive, and calls a function template with the
/// number type that the settings ask for.
namespace pixelplumb {

template <class Numbers>
struct WidestOfNumbers {
    using Type = Numbers;
};
template <template <class> class Numbers>
struct WidestOfNumbers<Numbers<std::int64_t>> {
    using Type = Numbers<Int128>;
};
template <template <class> class Outer, template <class> class Numbers>
struct WidestOfNumbers<Outer<Numbers<std::int64_t>>> {
    using Type = Outer<Numbers<Int128>>;
};
/// Numbers in 128 bits in place of exact ones in 64: the values are equal, and code that is not
/// timed is compiled for only one of them.
template <class Numbers>
using WidestOf = typename WidestOfNumbers<Numbers>::Type;

/// Every arithmetic; exact numbers in 64 bits where they suffice, with the same values.
struct InAnyArithmetic {
    template <class Geometry>
    static IntegerWidth widthFor(const Geometry &geometry, const FrameView &)
    {
        return integerWidthFor(geometry.vertices);
    }
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth width,
                                      const Function &function)
    {
        switch (settings.arithmetic) {
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
};

/// Exact numbers, in 64 bits and in 128, and the two floating ones, each a type of the kernel's
/// own.
template <class Narrow, class Wide, class Float32, class Float64>
struct InExactOrFloat {
    template <class Geometry>
    static IntegerWidth widthFor(const Geometry &, const FrameView &)
    {
        return IntegerWidth::Bits128;
    }
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth width,
                                      const Function &function)
    {
        switch (settings.arithmetic) {
        case Arithmetic::Float32:
            return function.template operator()<Float32>();
        case Arithmetic::Float64:
            return function.template operator()<Float64>();
        case Arithmetic::Exact:
        case Arithmetic::Fixed16: // not among the methods' arithmetics
        case Arithmetic::Fixed32:
            break;
        }
        if (width == IntegerWidth::Bits64)
            return function.template operator()<Narrow>();
        return function.template operator()<Wide>();
    }
};

/// Integers only: the kernel has no other numbers.
struct InIntegers {
    template <class Geometry>
    static IntegerWidth widthFor(const Geometry &, const FrameView &)
    {
        return IntegerWidth::Bits128;
    }
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &, IntegerWidth, const Function &function)
    {
        return function.template operator()<ExactArithmetic<Int128>>();
    }
};

} // namespace pixelplumb
