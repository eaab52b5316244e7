// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/rejectedprimitives.h"

#include "core/frame/framebuffer.h"
#include "core/methods/words/rejectiontext.h"
#include "core/plan/framereach.h"
#include "core/plan/framesquare.h"
#include "core/polygons/contours.h"
#include "core/polygons/curvechords.h"
#include "core/polygons/textoutlines.h"
#include "core/runs/contender.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether nothing was written of a completely recorded primitive.
bool wroteNothing(const ScanTrace &trace, std::size_t primitive)
{
    for (std::size_t span = trace.firstSpanOf(primitive); span < trace.endSpanOf(primitive);
         ++span) {
        for (std::size_t sample = trace.firstSampleOf(span); sample < trace.endSampleOf(span);
             ++sample) {
            if (trace.changes()[sample].isWritten())
                return false;
        }
    }
    return true;
}

SampledFrame drawnSamplesOf(const SceneRun &run)
{
    return {windowOf(run.scene.frame), run.settings.fillRule, run.antialiasing()};
}

/// The edges that bound a primitive, or that it consists of.
std::vector<ContourEdge> edgesOf(const Primitives &primitives, std::size_t index)
{
    if (primitives.isTriangle(index)) {
        const auto &[a, b, c] = primitives.triangles[index].vertices;
        return {{a.position, b.position}, {b.position, c.position}, {c.position, a.position}};
    }
    const Shape &shape = primitives.shape(index);
    const LatticePoint &first = shape.vertices[0].position;
    switch (shape.kind) {
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse: { // their box
        const LatticePoint &high = shape.vertices[1].position;
        const LatticePoint low = {2 * first.x - high.x, 2 * first.y - high.y};
        return {{low, {high.x, low.y}},
                {{high.x, low.y}, high},
                {high, {low.x, high.y}},
                {{low.x, high.y}, low}};
    }
    case PrimitiveKind::Text:
        return contoursOf(sharedOutlinesOf(shape)->polygon).edges;
    case PrimitiveKind::Bezier: {
        std::vector<ContourEdge> edges = contoursOf(chordsOf(shape)).edges;
        if (shape.fill == ShapeFill::Outline && !edges.empty())
            edges.pop_back(); // back to the beginning
        return edges;
    }
    default:
        return contoursOf(shape).edges;
    }
}

/// Where a primitive lies if no sample of it is drawn.
PrimitiveRejection missOf(const Primitives &primitives, std::size_t index, const FrameView &frame)
{
    const FrameSquare square(frame, unitsPerPixel);
    const auto enters = [&square](const ContourEdge &edge) {
        return edge.from == edge.to ? square.holds(edge.from)
                                    : square.isEnteredBy(edge.from, edge.to);
    };
    return std::ranges::any_of(edgesOf(primitives, index), enters)
        ? PrimitiveRejection::BetweenSamples
        : PrimitiveRejection::OutsideFrame;
}

/// A kernel's reason, made precise.
Rejection decided(const Rejection &rejection, const Primitives &primitives, std::size_t index,
                  const Scene &scene)
{
    return rejection == PrimitiveRejection::OutsideFrame
        ? missOf(primitives, index, windowOf(scene.frame))
        : rejection;
}

} // namespace

std::optional<Rejection> rejectionOf(const TracedScene &traced, std::size_t primitive)
{
    const auto rejection = traced.trace->setUp(primitive).rejection;
    return rejection
        ? std::optional(decided(*rejection, traced.primitives, primitive, traced.scene))
        : std::nullopt;
}

QString RejectedPrimitive::message() const
{
    return QStringLiteral("primitive %1 (%2): %3")
        .arg(primitive)
        .arg(nameOf(kind), rejectionText(rejection));
}

std::vector<RejectedPrimitive> rejectedPrimitives(const SceneRun &run)
{
    const Primitives &primitives = run.primitives;
    const FrameBuffer frame(run.scene.frame);
    const SampledFrame where = drawnSamplesOf(run);
    std::vector<RejectedPrimitive> rejected;
    TraceOptions untilTheFirstSpan;
    untilTheFirstSpan.detail = TraceDetail::Spans;
    untilTheFirstSpan.progress = [](const JobProgress &) { return false; };
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        const PrimitiveKind kind = primitives.kindOf(index);
        if (!run.method->draws(kind)) {
            rejected.push_back({index, kind, PrimitiveRejection::NotOfThisMethod});
            continue;
        }
        const Run one(run.method, aloneOf(primitives, index), run.settings, frame.view());
        // Cancelled, and so null, if a span was entered.
        auto trace = one.trace(frame.view(), untilTheFirstSpan);
        if (!trace && primitives.isTriangle(index)
            && reachOf(primitives.triangles[index], where).isEmpty()) {
            trace = one.trace(frame.view());
            if (!trace->isCut() && wroteNothing(*trace, 0))
                rejected.push_back({index, kind, missOf(primitives, index, where.frame)});
            continue;
        }
        if (!trace || trace->primitiveCount() == 0)
            continue;
        if (const auto rejection = trace->setUp(0).rejection)
            rejected.push_back({index, kind, decided(*rejection, primitives, index, run.scene)});
    }
    return rejected;
}

std::vector<RejectedPrimitive> rejectedPrimitives(const TracedScene &traced)
{
    const Primitives &primitives = traced.primitives;
    const ScanTrace &trace = *traced.trace;
    const SampledFrame where = drawnSamplesOf(traced);
    const auto liesBetween = [&](std::size_t triangle) {
        return reachOf(primitives.triangles[triangle], where).isEmpty()
            && wroteNothing(trace, triangle);
    };
    std::vector<RejectedPrimitive> rejected;
    const std::size_t whole = trace.primitiveCount() - (trace.isCut() ? 1 : 0);
    for (std::size_t index = 0; index < trace.primitiveCount(); ++index) {
        if (std::ranges::binary_search(trace.rejectedPrimitives(), index))
            rejected.push_back({index, primitives.kindOf(index), *rejectionOf(traced, index)});
        else if (index < whole && primitives.isTriangle(index) && liesBetween(index))
            rejected.push_back(
                {index, PrimitiveKind::Triangle, missOf(primitives, index, where.frame)});
    }
    return rejected;
}

} // namespace pixelplumb
