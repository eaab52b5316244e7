// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolation.h"

#include "core/methods/interpolationkernel.h"
#include "core/methods/plannedmethod.h"

namespace pixelplumb {

namespace {

/// What the triangles are given that a person wrote. Of a camera's triangles only what an effect
/// reads counts, and then it is the effects' kernels that draw.
CarriedChannels carriedBy(const Primitives &primitives)
{
    CarriedChannels carried;
    const std::size_t written = primitives.triangles.size() - primitives.sources.size();
    for (const TriangleAttributes &attributes : primitives.attributes) {
        if (attributes.triangle >= written)
            break;
        for (const VertexAttributes &vertex : attributes.vertices) {
            carried.depth |= vertex.z != 0;
            carried.texture |= vertex.texture != std::array<Attribute, 2>{};
            carried.normal |= vertex.normal != std::array<Attribute, 3>{};
        }
    }
    return carried;
}

template <InterpolationForm Form>
std::unique_ptr<ScanTrace> traceCarried(const Primitives &primitives, const ScanSettings &settings,
                                        FrameView frame, const TraceOptions &options)
{
    using Kernel = InterpolationKernel<Form>;
    const CarriedChannels carried = carriedBy(primitives);
    if (carried.count() == colourChannelCount)
        return traceWith<Kernel>(primitives, settings, frame, options);
    return Kernel::withNumbers(settings, IntegerWidth::Bits128, [&]<class Number>() {
        using R = InterpolationRecording<Form, Number, channelCount>;
        return recordTrace<R>(
            primitives.size(), settings, options,
            [&](std::size_t index) { return primitives.isTriangle(index); },
            [&](std::size_t index, const TraceRecorder<R> &recorder) {
                InterpolationScan<Form, Number, WideBeside<Number>, channelCount, TraceRecorder<R>>(
                    primitives.triangles[index], primitives.attributesOf(index), carried, settings,
                    frame, recorder)
                    .run();
            },
            TablesOf<R>::of(carried));
    });
}

template <InterpolationForm Form, ShadedMethod shaded>
Method interpolationMethod()
{
    using Kernel = InterpolationKernel<Form>;
    Method method = methodOf<Kernel>();
    method.draw = drawPlanned<shaded, drawWith<Kernel>>;
    method.drawEffects = drawEffects<shaded>;
    method.trace = tracePlanned<shaded, traceCarried<Form>>;
    method.pseudocode = interpolationPseudocode(Form);
    method.shadedPseudocode = pixelplumb::shadedPseudocode(Form);
    method.family = MethodFamily::Interpolation;
    method.effects.assign(allEffects.begin(), allEffects.end());
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn, FillRule::Open};
    method.fillRuleReason = spanRuleReason(SpanAxis::Column);
    return method;
}

} // namespace

Method bilinearInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Bilinear, ShadedMethod::Bilinear>();
    method.id = QStringLiteral("interpolate-bilinear");
    method.title = QStringLiteral("Bilinear interpolation");
    method.source = QStringLiteral("Scan Conversion slides, “1. Bilinear Interpolation”");
    method.summary = QStringLiteral("Interpolates along both edges and then along the column, each "
                                    "by adding a rate; what is covered is exact.");
    return method;
}

Method planeInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Plane, ShadedMethod::Plane>();
    method.id = QStringLiteral("interpolate-plane");
    method.title = QStringLiteral("Plane equation");
    method.source = QStringLiteral("Scan Conversion slides, “2. Plane Equation”");
    method.summary = QStringLiteral("Evaluates v = a·x + b·y + c of the plane through the three "
                                    "values at each sample; what is covered is exact.");
    return method;
}

Method barycentricInterpolationMethod()
{
    Method method
        = interpolationMethod<InterpolationForm::Barycentric, ShadedMethod::Barycentric>();
    method.id = QStringLiteral("interpolate-barycentric");
    method.title = QStringLiteral("Barycentric interpolation");
    method.source = QStringLiteral("Scan Conversion slides, “3. Barycentric Coordinates” and "
                                   "“Computing Barycentric Coordinates”");
    method.summary = QStringLiteral("Weights the three vertices' values with α, β and γ at each "
                                    "sample; what is covered is exact.");
    return method;
}

} // namespace pixelplumb
