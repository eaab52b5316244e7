// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/mistakenmethod.h"
#include "core/methods/tests/edgetestrecording.h"
#include "core/scan/tests/mistakentestscan.h"

namespace pixelplumb {

template <EdgeTestForm form>
struct EdgeTestKernel : TriangleKernel,
                        InExactOrFloat<ExactPlane<std::int64_t>, ExactPlane<Int128>,
                                       FloatPlane<float>, FloatPlane<double>> {
    /// The integers must hold samples anywhere in the frame, and the off-screen point.
    static IntegerWidth widthFor(const Triangle &triangle, const FrameView &frame)
    {
        const LatticePoint first = latticePixel(frame.firstColumn, frame.firstRow);
        const LatticePoint end = latticePixel(frame.endColumn(), frame.endRow());
        const bool fits = integerWidthFor(triangle) == IntegerWidth::Bits64 && isNarrow(first)
            && isNarrow(end) && isNarrow(frame.offScreenPoint);
        return fits ? IntegerWidth::Bits64 : IntegerWidth::Bits128;
    }

    template <class A>
    using Recording = EdgeTestRecording<A, form>;

    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        testSamples<A, form>(triangle, settings, frame, observer);
    }
};

/// The mistaken edge test, in exact numbers alone.
template <EdgeTestForm form>
struct MistakenEdgeTestKernel : EdgeTestKernel<form> {
    /// What a mistaken program does along a span is not tested again from the span's state.
    template <class A>
    using Recording = EdgeTestRecords<A, form>;

    template <class Function>
    static decltype(auto) withNumbers(const ScanSettings &, IntegerWidth, const Function &function)
    {
        return function.template operator()<ExactPlane<Int128>>();
    }
    template <class A, class Observer>
    static void scan(const Triangle &triangle, const ScanSettings &settings, FrameView frame,
                     Observer observer)
    {
        testSamplesMistaken<A, form>(triangle, settings, frame, observer);
    }
};

template <EdgeTestForm form>
bool drawTests(const Run &run, FrameView frame, const ProgressListener &listener)
{
    return run.settings.testBugs.isRight()
        ? drawWith<EdgeTestKernel<form>>(run, frame, listener)
        : drawWith<MistakenEdgeTestKernel<form>>(run, frame, listener);
}
template <EdgeTestForm form>
std::unique_ptr<ScanTrace> traceTests(const Run &run, FrameView frame, const TraceOptions &options)
{
    return run.settings.testBugs.isRight()
        ? traceWith<EdgeTestKernel<form>>(run, frame, options)
        : traceMistaken<MistakenEdgeTestKernel<form>>(run, frame, options);
}

/// The common part of all methods that test samples. The solved form has units of its own, in which
/// no mistakes are told.
template <EdgeTestForm form>
Method edgeTestMethod()
{
    Method method = methodOf<EdgeTestKernel<form>>();
    if constexpr (form.line != LineForm::Solved) {
        method.draw = drawTests<form>;
        method.trace = traceTests<form>;
        method.testsEdges = true;
    }
    method.pseudocode = edgeTestPseudocode(form);
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact};
    if (form.visited == VisitedSamples::BoundingBox)
        method.variants = {Variant::RoundedBox};
    method.fillRules.assign(allFillRules.begin(), allFillRules.end());
    return method;
}

} // namespace pixelplumb
