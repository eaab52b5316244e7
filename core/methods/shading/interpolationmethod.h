// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/interpolationkernel.h"
#include "core/methods/shading/plannedmethod.h"

/// The common part of the interpolation methods. Each form is thousands of lines of templates, so
/// each is compiled in a file of its own.
namespace pixelplumb {

/// The channels that a person gave the triangles. Of a camera's triangles only those count that an
/// effect reads, and then the effects' kernels draw.
CarriedChannels carriedBy(const Primitives &primitives);

template <InterpolationForm Form>
std::unique_ptr<ScanTrace> traceCarried(const Run &run, FrameView frame,
                                        const TraceOptions &options)
{
    using Kernel = InterpolationKernel<Form>;
    const Primitives &primitives = run.primitives;
    const ScanSettings &settings = run.settings;
    const CarriedChannels carried = carriedBy(primitives);
    if (carried.count() == colourChannelCount)
        return traceWith<Kernel>(run, frame, options);
    return Kernel::withNumbers(settings, IntegerWidth::Bits128, [&]<class Number>() {
        using R = InterpolationRecording<Form, Number, channelCount>;
        return recordTrace<R>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return primitives.isTriangle(index); },
            [&](std::size_t index, const ObserverOf<R> &recorder) {
                const auto listener = listenerFor<Form>(recorder);
                const FormTriangle<Form> scanned(primitives.triangles[index],
                                                 primitives.attributesOf(index));
                InterpolationScan<Form, Number, WideBeside<Number>, channelCount,
                                  std::remove_const_t<decltype(listener)>>(
                    scanned.triangle, &scanned.attributes, carried, settings, frame, listener)
                    .run();
            },
            TablesOf<R>::of(interpolationScope(Form, carried)));
    });
}

/// A method that draws colours, and traces z, u, v and the normal where a person gives them.
template <InterpolationForm Form>
Method plainInterpolationMethod()
{
    using Kernel = InterpolationKernel<Form>;
    Method method = methodOf<Kernel>();
    method.draw = drawWith<Kernel>;
    method.trace = traceCarried<Form>;
    method.pseudocode = interpolationPseudocode(Form);
    method.family = MethodFamily::Interpolation;
    method.effects = {Effect::SmoothColour, Effect::Clipping};
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact};
    method.spanAxis = axisOf(Form);
    if (method.spanAxis == SpanAxis::Row) {
        method.fillRules = {FillRule::Closed, FillRule::TopLeft, FillRule::Open};
        method.fillRuleReason = spanRuleReason(method.spanAxis);
        return method;
    }
    method.fillRules
        = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::TopLeft, FillRule::Open};
    method.fillRuleReason = "a column's bounds tell how their edges run, but not on which side the "
                            "off-screen point lies";
    return method;
}

/// An interpolation method with all effects.
template <InterpolationForm Form, ShadedMethod shaded>
Method interpolationMethod()
{
    Method method = plainInterpolationMethod<Form>();
    method.draw = drawPlanned<shaded, drawWith<InterpolationKernel<Form>>>;
    method.trace = tracePlanned<shaded, traceCarried<Form>>;
    method.shadedPseudocode = pixelplumb::shadedPseudocode(Form);
    method.effects.assign(allEffects.begin(), allEffects.end());
    return method;
}

} // namespace pixelplumb
