// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/walks/edgewalkmethod.h"

/// How an edge walk becomes a method that can be given variants.
namespace pixelplumb {

/// An edge walk with the departures of the settings; its exact numbers always have 128 bits, which
/// hold the products of departures.
template <EdgeWalkForm form>
struct VariedEdgeWalkKernel : EdgeWalkKernel<form> {
    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &settings, IntegerWidth,
                                      const Function &function)
    {
        return InAnyArithmetic::withNumbers(settings, IntegerWidth::Bits128, [&]<class A>() {
            return function.template operator()<WidestOf<A>>();
        });
    }
    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        walkVariedEdges<A, form.axis>(triangle, settings, frame, observer);
    }
};

/// The variants that an edge walk accepts.
inline std::vector<Variant> edgeWalkVariants()
{
    return {Variant::NoColourPreStep, Variant::NoEdgePreStep, Variant::DivisorMinusOne,
            Variant::DivisorPlusOne, Variant::UnsortedColours};
}

/// Draws and traces a method that has a second kernel type for departures: uses it only if the
/// settings ask for some.
template <auto right, auto varied>
bool drawVaried(const Run &run, FrameView frame, const ProgressListener &listener)
{
    return (run.settings.variants.isEmpty() ? right : varied)(run, frame, listener);
}
template <auto right, auto varied>
std::unique_ptr<ScanTrace> traceVaried(const Run &run, FrameView frame, const TraceOptions &options)
{
    return (run.settings.variants.isEmpty() ? right : varied)(run, frame, options);
}

} // namespace pixelplumb
