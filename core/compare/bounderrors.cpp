// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"

#include "core/compare/exactbounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

/// The largest magnitude that a bound of the triangle can have along an axis, px.
double largestBound(const Triangle &triangle, SpanAxis axis)
{
    double largest = 0;
    for (const Vertex &vertex : triangle.vertices) {
        const Lattice coordinate = axis == SpanAxis::Column ? vertex.position.y : vertex.position.x;
        largest = std::max(largest, std::abs(double(coordinate)) / unitsPerPixel);
    }
    return largest;
}

/// The first column or row of the triangle, inside the frame or not: the increments start there.
std::int64_t firstPlace(const Triangle &triangle, SpanAxis axis)
{
    Lattice least = std::numeric_limits<Lattice>::max();
    for (const Vertex &vertex : triangle.vertices)
        least = std::min(least, axis == SpanAxis::Column ? vertex.position.x : vertex.position.y);
    return ceilPixel(least);
}

/// The samples that a span covers by exact bounds: along the span, half-open.
std::pair<std::int64_t, std::int64_t> exactSamples(const ExactBounds &bounds, FillRule rule)
{
    const auto ceiling = [](const Quantity &bound) {
        return std::int64_t(ceilDivide(bound.numerator(), bound.denominator()));
    };
    const std::int64_t end = rule == FillRule::Closed
        ? std::int64_t(floorDivide(bounds.upper.numerator(), bounds.upper.denominator())) + 1
        : ceiling(bounds.upper);
    return {ceiling(bounds.lower), end};
}

/// The method's own spans in exact numbers where it has them, else the oracle's.
bool coversOtherSamples(const SpanRecord &span, const ExactBounds &bounds, FillRule rule,
                        const ScanTrace *exactRun)
{
    auto [first, end] = exactSamples(bounds, rule);
    if (exactRun) {
        const auto twin = exactRun->spanOn(span.primitive, span.place.axis, span.place.coordinate);
        if (twin) {
            const SpanRecord exact = exactRun->span(*twin);
            first = exact.firstSample;
            end = exact.endSample;
        }
    }
    const bool isEmpty = span.firstSample >= span.endSample;
    if (first >= end || isEmpty)
        return (first >= end) != isEmpty;
    return span.firstSample != first || span.endSample != end;
}

std::unique_ptr<ScanTrace> spansOf(const Scene &scene, const Method &method,
                                   const Primitives &primitives, Arithmetic arithmetic,
                                   const std::function<bool()> &goesOn)
{
    ScanSettings settings = scene.settings;
    settings.arithmetic = arithmetic;
    TraceOptions options;
    options.detail = TraceDetail::Spans;
    if (goesOn)
        options.progress = [&goesOn](std::size_t) { return goesOn(); };
    const FrameBuffer unseen(scene.frame);
    return method.trace(primitives, settings, unseen.view(), options);
}

BoundErrors errorsOf(const ScanTrace &trace, const Triangle &triangle, const ScanTrace *exactRun)
{
    BoundErrors errors;
    errors.arithmetic = trace.settings().arithmetic;
    for (std::size_t index = 0; index < trace.spanCount(); ++index) {
        const SpanRecord span = trace.span(index);
        const auto exact = exactBoundsOn(triangle, span.place);
        if (!exact || span.lower.isNone() || span.upper.isNone())
            continue;
        BoundError error;
        error.place = span.place;
        error.lower = errorOf(span.lower, exact->lower);
        error.upper = errorOf(span.upper, exact->upper);
        const auto additions
            = double(span.place.coordinate - firstPlace(triangle, span.place.axis) + 1);
        error.limit
            = errorLimit(errors.arithmetic, additions, largestBound(triangle, span.place.axis));
        error.isWrong = coversOtherSamples(span, *exact, trace.settings().fillRule, exactRun);
        if (error.isWrong) {
            ++errors.wrongCount;
            if (!errors.firstWrong)
                errors.firstWrong = errors.spans.size();
        }
        errors.spans.push_back(error);
    }
    return errors;
}

} // namespace

std::optional<std::vector<BoundErrors>> boundErrorsOf(const Scene &scene, std::size_t triangle,
                                                      const std::function<bool()> &goesOn)
{
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    std::vector<BoundErrors> all;
    if (!method || !method->draws(PrimitiveKind::Triangle) || triangle >= scene.triangles.size())
        return all;
    Primitives alone = primitivesOnSamples(scene);
    alone.triangles = {alone.triangles[triangle]};
    alone.shapes.clear();
    alone.attributes.clear();
    std::unique_ptr<ScanTrace> exactRun;
    if (method->supports(Arithmetic::Exact)) {
        exactRun = spansOf(scene, *method, alone, Arithmetic::Exact, goesOn);
        if (!exactRun)
            return std::nullopt;
    }
    for (const Arithmetic arithmetic : method->arithmetics) {
        if (arithmetic == Arithmetic::Exact)
            continue;
        const auto trace = spansOf(scene, *method, alone, arithmetic, goesOn);
        if (!trace)
            return std::nullopt;
        BoundErrors errors = errorsOf(*trace, alone.triangles.front(), exactRun.get());
        if (!errors.spans.empty())
            all.push_back(std::move(errors));
    }
    return all;
}

double errorLimit(Arithmetic arithmetic, double additions, double largest)
{
    switch (arithmetic) {
    case Arithmetic::Exact:
        return 0;
    case Arithmetic::Float32: {
        const float above = std::nextafter(float(largest), std::numeric_limits<float>::infinity());
        return additions * double(above - float(largest)) / 2;
    }
    case Arithmetic::Float64: {
        const double above = std::nextafter(largest, std::numeric_limits<double>::infinity());
        return additions * (above - largest) / 2;
    }
    case Arithmetic::Fixed16:
        return std::ldexp(additions, -17);
    case Arithmetic::Fixed32:
        return std::ldexp(additions, -33);
    }
    return 0;
}

} // namespace pixelplumb
