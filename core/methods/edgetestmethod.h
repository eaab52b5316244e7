// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgetestcolumns.h"
#include "core/methods/edgetestrecording.h"
#include "core/methods/method.h"

namespace pixelplumb {

/// Calls a template with the type in which edge functions are computed.
template <class Function>
decltype(auto) withPlaneArithmetic(Arithmetic arithmetic, const Function &function)
{
    switch (arithmetic) {
    case Arithmetic::Float32:
        return function.template operator()<FloatPlane<float>>();
    case Arithmetic::Float64:
        return function.template operator()<FloatPlane<double>>();
    case Arithmetic::Exact:
    case Arithmetic::Fixed16:
    case Arithmetic::Fixed32:
        break;
    }
    return function.template operator()<ExactPlane>();
}

template <EdgeTestForm form>
void drawByEdgeTest(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    withPlaneArithmetic(settings.arithmetic, [&]<class A>() {
        for (const Triangle &triangle : primitives.triangles)
            testSamples<A, form>(triangle, settings, frame, NullObserver{});
    });
}

template <EdgeTestForm form>
std::unique_ptr<ScanTrace> traceEdgeTest(const Primitives &primitives, const ScanSettings &settings,
                                         FrameView frame, const TraceOptions &options)
{
    return withPlaneArithmetic(settings.arithmetic, [&]<class A>() {
        return recordTrace<EdgeTestRecording<A, form>>(
            primitives.size(), settings, options,
            [&](std::size_t primitive) { return primitives.isTriangle(primitive); },
            [&](std::size_t primitive, const auto &recorder) {
                testSamples<A, form>(primitives.triangles[primitive], settings, frame, recorder);
            });
    });
}

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
    method.draw = drawByEdgeTest<form>;
    method.trace = traceEdgeTest<form>;
    return method;
}

} // namespace pixelplumb
