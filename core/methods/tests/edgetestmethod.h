// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/kernelmethod.h"
#include "core/methods/tests/edgetestrecording.h"

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

/// The common part of all methods that test samples.
template <EdgeTestForm form>
Method edgeTestMethod()
{
    Method method = methodOf<EdgeTestKernel<form>>();
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
