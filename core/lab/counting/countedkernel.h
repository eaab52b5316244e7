// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/counting/countedarithmetic.h"
#include "core/lab/counting/countedbias.h"
#include "core/lab/counting/countedmethods.h"
#include "core/lab/counting/countingobserver.h"
#include "core/scan/kernelnumbers.h"

/// How a method's kernel (methods/kernelmethod.h) runs with counting numbers: in the very templates
/// that draw, with counting types in place of its number types.
namespace pixelplumb {

/// The counting type that replaces a kernel's number type. Exact numbers count in 128 bits whatever
/// width would suffice: the operations are the same.
template <class A>
struct CountingTwin;
template <class T>
struct CountingTwin<RoundedArithmetic<T>> {
    using Type = CountedRounded<T>;
};
template <class Integer>
struct CountingTwin<ExactArithmetic<Integer>> {
    using Type = CountedExact;
};
template <class Base>
struct CountingTwin<ConstantRateArithmetic<Base>> {
    using Type = ConstantRateArithmetic<typename CountingTwin<Base>::Type>;
};
template <class Number>
struct CountingTwin<BiasArithmetic<Number>> {
    using Type = CountedBias;
};
template <class Integer>
struct CountingTwin<ExactPlane<Integer>> {
    using Type = CountedExactPlane;
};
template <class Float>
struct CountingTwin<FloatPlane<Float>> {
    using Type = CountedFloatPlane<Float>;
};
template <>
struct CountingTwin<CommonFraction> {
    using Type = FractionOf<Counted<Int128>>;
};
template <std::floating_point Float>
struct CountingTwin<Float> {
    using Type = Counted<Float>;
};

/// Draws and counts. None when the listener ended it.
template <class Kernel>
std::optional<OperationCounts> countWith(const Primitives &primitives, const ScanSettings &settings,
                                         FrameView frame, const ProgressListener &progress)
{
    OperationTally tally;
    const auto total = std::int64_t(primitives.size());
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        if (!goesOn(progress, {JobPhase::Drawing, std::int64_t(index), total}))
            return std::nullopt;
        if (!Kernel::draws(primitives, index))
            continue;
        const auto &geometry = Kernel::geometryOf(primitives, index);
        tally.beginPrimitive();
        Kernel::withNumbers(settings, IntegerWidth::Bits128, [&]<class A>() {
            Kernel::template scan<typename CountingTwin<A>::Type>(geometry, settings, frame,
                                                                  CountingObserver(tally));
        });
    }
    return tally.counts;
}

} // namespace pixelplumb
