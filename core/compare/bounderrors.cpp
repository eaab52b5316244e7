// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compare/bounderrors.h"

#include "core/compare/exactbounds.h"
#include "core/scan/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

/// The range in which the bounds of a triangle's columns or rows can lie, px.
struct BoundRange {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    BoundRange(const Triangle &triangle, SpanAxis axis)
    {
        for (const Vertex &vertex : triangle.vertices) {
            const LatticePoint &point = vertex.position;
            const double bound
                = double(axis == SpanAxis::Column ? point.y : point.x) / unitsPerPixel;
            lowest = std::min(lowest, bound);
            highest = std::max(highest, bound);
        }
    }
    double largest() const { return std::max(std::abs(lowest), std::abs(highest)); }
    double extent() const { return highest - lowest; }
};

/// The first column or row of the triangle, inside the frame or not: the increments start there.
std::int64_t firstPlace(const Triangle &triangle, SpanAxis axis)
{
    Lattice least = std::numeric_limits<Lattice>::max();
    for (const Vertex &vertex : triangle.vertices)
        least = std::min(least, axis == SpanAxis::Column ? vertex.position.x : vertex.position.y);
    return ceilPixel(least);
}

/// The samples that a span covers by exact bounds: half-open, along the span.
std::pair<std::int64_t, std::int64_t> exactSamples(const ExactBounds &bounds, FillRule rule)
{
    const auto floorOf = [](const Quantity &bound) {
        return std::int64_t(floorDivide(bound.numerator(), bound.denominator()));
    };
    const auto ceilOf = [](const Quantity &bound) {
        return std::int64_t(ceilDivide(bound.numerator(), bound.denominator()));
    };
    const Interval interval = columnIntervals(rule).rows;
    return {ownsFirst(interval) ? ceilOf(bounds.lower) : floorOf(bounds.lower) + 1,
            ownsLast(interval) ? floorOf(bounds.upper) + 1 : ceilOf(bounds.upper)};
}

/// Compares with the method's own exact span where there is one, else with the oracle's.
void compareSamples(BoundError &error, const SpanRecord &span, const ExactBounds &bounds,
                    FillRule rule, const ScanTrace *exactRun)
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
    if (first >= end || isEmpty) {
        error.isLowerWrong = error.isUpperWrong = (first >= end) != isEmpty;
        return;
    }
    error.isLowerWrong = span.firstSample != first;
    error.isUpperWrong = span.endSample != end;
}

std::unique_ptr<ScanTrace> spansOf(const Scene &scene, const Method &method,
                                   const Primitives &primitives, Arithmetic arithmetic,
                                   const ProgressListener &listener)
{
    ScanSettings settings = scene.settings;
    settings.arithmetic = arithmetic;
    TraceOptions options;
    options.detail = TraceDetail::Spans;
    options.progress = listener;
    const FrameBuffer unseen(scene.frame);
    return Run(&method, primitives, settings, unseen.view()).trace(unseen.view(), options);
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
        const BoundRange range(triangle, span.place.axis);
        error.limit = errorLimit(errors.arithmetic, additions, range.largest(), range.extent());
        compareSamples(error, span, *exact, trace.settings().fillRule, exactRun);
        errors.spans.push_back(error);
    }
    return errors;
}

} // namespace

std::optional<std::vector<BoundErrors>> boundErrorsOf(const Scene &scene, std::size_t triangle,
                                                      const ProgressListener &listener)
{
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    std::vector<BoundErrors> all;
    if (!method || !method->draws(PrimitiveKind::Triangle) || !scene.hasTriangles())
        return all;
    Primitives alone = primitivesOnSamples(scene);
    if (triangle >= alone.triangles.size())
        return all;
    alone.triangles = {alone.triangles[triangle]};
    alone.shapes.clear();
    alone.attributes.clear();
    std::unique_ptr<ScanTrace> exactRun;
    if (method->supports(Arithmetic::Exact)) {
        exactRun = spansOf(scene, *method, alone, Arithmetic::Exact, listener);
        if (!exactRun)
            return std::nullopt;
    }
    for (const Arithmetic arithmetic : method->arithmetics) {
        if (arithmetic == Arithmetic::Exact)
            continue;
        const auto trace = spansOf(scene, *method, alone, arithmetic, listener);
        if (!trace)
            return std::nullopt;
        BoundErrors errors = errorsOf(*trace, alone.triangles.front(), exactRun.get());
        if (!errors.spans.empty())
            all.push_back(std::move(errors));
    }
    return all;
}

} // namespace pixelplumb
