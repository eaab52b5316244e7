// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolation.h"

#include "core/methods/interpolationcolumns.h"
#include "core/methods/interpolationrecording.h"

#include <algorithm>

namespace pixelplumb {

namespace {

template <class Function>
decltype(auto) withNumber(Arithmetic arithmetic, const Function &function)
{
    switch (arithmetic) {
    case Arithmetic::Float32:
        return function.template operator()<float>();
    case Arithmetic::Float64:
        return function.template operator()<double>();
    case Arithmetic::Exact:
    case Arithmetic::Fixed16: // not among the methods' arithmetics
    case Arithmetic::Fixed32:
        break;
    }
    return function.template operator()<Ratio>();
}

std::array<VertexAttributes, 3> attributesOf(const Primitives &primitives, std::size_t triangle)
{
    const auto found = std::ranges::lower_bound(primitives.attributes, triangle, {},
                                                &TriangleAttributes::triangle);
    if (found == primitives.attributes.end() || found->triangle != triangle)
        return {};
    return found->vertices;
}

template <InterpolationForm Form>
void draw(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    withNumber(settings.arithmetic, [&]<class Number>() {
        for (std::size_t i = 0; i < primitives.triangles.size(); ++i) {
            InterpolationScan<Form, Number, NullObserver>(
                primitives.triangles[i], attributesOf(primitives, i), settings, frame, {})
                .run();
        }
    });
}

template <InterpolationForm Form>
std::unique_ptr<ScanTrace> trace(const Primitives &primitives, const ScanSettings &settings,
                                 FrameView frame, const TraceOptions &options)
{
    return withNumber(settings.arithmetic, [&]<class Number>() {
        using Recorder = TraceRecorder<InterpolationRecording<Form, Number>>;
        return recordTrace<InterpolationRecording<Form, Number>>(
            primitives.size(), settings, options,
            [&](std::size_t primitive) { return primitives.isTriangle(primitive); },
            [&](std::size_t primitive, const Recorder &recorder) {
                InterpolationScan<Form, Number, Recorder>(primitives.triangles[primitive],
                                                          attributesOf(primitives, primitive),
                                                          settings, frame, recorder)
                    .run();
            });
    });
}

template <InterpolationForm Form>
Method interpolationMethod()
{
    Method method;
    method.family = MethodFamily::Interpolation;
    method.effects = {QStringLiteral("smooth colour"), QStringLiteral("depth"),
                      QStringLiteral("texture coordinates"), QStringLiteral("normals"),
                      QStringLiteral("clipping to the frame")};
    method.arithmetics = {Arithmetic::Exact, Arithmetic::Float32, Arithmetic::Float64};
    method.stableArithmetics = {Arithmetic::Exact};
    method.fillRules = {FillRule::Closed, FillRule::HalfOpenColumn};
    method.fillRuleReason
        = QStringLiteral("a column ends at its two bounds whatever edge they belong to");
    method.setUpColumns = interpolationSetUpColumns(Form);
    method.spanColumns = interpolationSpanColumns(Form);
    method.sampleColumns = interpolationSampleColumns(Form);
    method.draw = draw<Form>;
    method.trace = trace<Form>;
    return method;
}

} // namespace

Method bilinearInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Bilinear>();
    method.id = QStringLiteral("interpolate-bilinear");
    method.title = QStringLiteral("Bilinear interpolation");
    method.source = QStringLiteral("seed 003, slide “1. Bilinear Interpolation”");
    method.summary = QStringLiteral("Interpolates along both edges and then along the column, each "
                                    "by adding a rate; what is covered is exact.");
    return method;
}

Method planeInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Plane>();
    method.id = QStringLiteral("interpolate-plane");
    method.title = QStringLiteral("Plane equation");
    method.source = QStringLiteral("seed 003, slide “2. Plane Equation”");
    method.summary = QStringLiteral("Evaluates v = a·x + b·y + c of the plane through the three "
                                    "values at each sample; what is covered is exact.");
    return method;
}

Method barycentricInterpolationMethod()
{
    Method method = interpolationMethod<InterpolationForm::Barycentric>();
    method.id = QStringLiteral("interpolate-barycentric");
    method.title = QStringLiteral("Barycentric interpolation");
    method.source = QStringLiteral("seed 003, slides “3. Barycentric Coordinates” and “Computing "
                                   "Barycentric Coordinates”");
    method.summary = QStringLiteral("Weights the three vertices' values with α, β and γ at each "
                                    "sample; what is covered is exact.");
    return method;
}

} // namespace pixelplumb
