// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/methods/interpolation.h"

#include "core/methods/interpolationcolumns.h"
#include "core/methods/interpolationrecording.h"
#include "core/methods/kernelmethod.h"

#include <algorithm>

namespace pixelplumb {

namespace {

std::array<VertexAttributes, 3> attributesOf(const Primitives &primitives, std::size_t triangle)
{
    const auto found = std::ranges::lower_bound(primitives.attributes, triangle, {},
                                                &TriangleAttributes::triangle);
    if (found == primitives.attributes.end() || found->triangle != triangle)
        return {};
    return found->vertices;
}

struct AttributedTriangle {
    const Triangle &triangle;
    std::array<VertexAttributes, 3> attributes;
};

template <InterpolationForm Form>
struct InterpolationKernel : TriangleKernel, InExactOrFloat<Ratio, float, double> {
    template <class Number>
    using Recording = InterpolationRecording<Form, Number>;

    static AttributedTriangle geometryOf(const Primitives &primitives, std::size_t index)
    {
        return {primitives.triangles[index], attributesOf(primitives, index)};
    }
    template <class Number, class Observer>
    static void scan(const AttributedTriangle &scanned, const ScanSettings &settings,
                     FrameView frame, Observer observer)
    {
        InterpolationScan<Form, Number, Observer>(scanned.triangle, scanned.attributes, settings,
                                                  frame, observer)
            .run();
    }
};

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
    method.draw = drawWith<InterpolationKernel<Form>>;
    method.trace = traceWith<InterpolationKernel<Form>>;
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
