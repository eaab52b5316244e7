// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/mistakenmethod.h"
#include "core/methods/walks/edgewalkmethod.h"
#include "core/scan/mistakes/mistakenedgewalk.h"

/// How an edge walk becomes a method that can be given variants and bugs.
namespace pixelplumb {

/// The mistaken scan of an edge walk; its exact numbers always have 128 bits.
template <EdgeWalkForm form>
struct VariedEdgeWalkKernel : EdgeWalkKernel<form> {
    /// What a mistaken program does along a span cannot be walked again from the span's state.
    template <class A>
    using Recording = EdgeWalkRecords<A, form>;

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
        walkMistakenEdges<A, form.axis>(triangle, settings, frame, observer);
    }
};

/// The variants that an edge walk accepts.
inline std::vector<Variant> edgeWalkVariants()
{
    return {Variant::NoColourPreStep, Variant::NoEdgePreStep, Variant::DivisorMinusOne,
            Variant::DivisorPlusOne, Variant::UnsortedColours};
}

/// Draws and traces a method that has a second kernel for mistakes: uses it only if the settings
/// ask for some.
template <auto right, auto varied>
bool drawVaried(const Run &run, FrameView frame, const ProgressListener &listener)
{
    return (run.settings.isRight() ? right : varied)(run, frame, listener);
}
template <auto right, class Varied>
std::unique_ptr<ScanTrace> traceVaried(const Run &run, FrameView frame, const TraceOptions &options)
{
    return run.settings.isRight()     ? right(run, frame, options)
        : run.settings.bugs.isRight() ? traceWith<Varied>(run, frame, options)
                                      : traceMistaken<Varied>(run, frame, options);
}

} // namespace pixelplumb
