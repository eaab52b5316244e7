// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgetestcolumns.h"
#include "core/methods/edgetestrecording.h"
#include "core/methods/kernelmethod.h"
#include "core/methods/method.h"

namespace pixelplumb {

template <EdgeTestForm form>
struct EdgeTestKernel : TriangleKernel,
                        InExactOrFloat<ExactPlane, FloatPlane<float>, FloatPlane<double>> {
    template <class A>
    using Recording = EdgeTestRecording<A, form>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        testSamples<A, form>(triangle, settings, frame, observer);
    }
};

/// What all methods that test samples have in common.
template <EdgeTestForm form>
Method edgeTestMethod()
{
    Method method;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("clipping to the frame")};
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules.assign(allFillRules.begin(), allFillRules.end());
    method.setUpColumns = edgeTestSetUpColumns(form);
    method.spanColumns = edgeTestSpanColumns(form);
    method.sampleColumns = edgeTestSampleColumns(form);
    method.draw = drawWith<EdgeTestKernel<form>>;
    method.trace = traceWith<EdgeTestKernel<form>>;
    return method;
}

} // namespace pixelplumb
