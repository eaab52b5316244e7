// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/walks/edgewalkrecording.h"

namespace pixelplumb {

template <EdgeWalkForm form>
struct EdgeWalkKernel : TriangleKernel, InAnyArithmetic {
    static constexpr EdgeWalkForm walkForm = form;

    template <class A>
    using Recording = EdgeWalkRecording<A, form>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        walkEdges<A, form.axis>(triangle, settings, frame, observer);
    }
};

/// The common part of all edge walks; the kernel is an EdgeWalkKernel, maybe with other numbers.
template <class Kernel>
Method edgeWalkMethod()
{
    Method method = methodOf<Kernel>();
    method.pseudocode = edgeWalkPseudocode(Kernel::walkForm);
    method.spanAxis = Kernel::walkForm.axis;
    method.fillRuleReason = spanRuleReason(method.spanAxis);
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    return method;
}

} // namespace pixelplumb
