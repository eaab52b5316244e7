// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/explain/rejectedprimitives.h"

#include "core/frame/framebuffer.h"
#include "core/methods/words/rejectiontext.h"
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
    case PrimitiveKind::Point: {
        std::vector<ContourEdge> points;
        for (const Vertex &vertex : shape.vertices)
            points.push_back({vertex.position, vertex.position});
        return points;
    }
    case PrimitiveKind::Text:
        return sharedOutlinesOf(shape)->contours.edges;
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

/// Why nothing is drawn of a primitive, whatever hides it in the scene: the kernel draws it alone,
/// up to the first pixel that it writes.
std::optional<Rejection> rejectionAlone(const SceneRun &run, std::size_t index,
                                        const FrameBuffer &frame)
{
    const Primitives &primitives = run.primitives;
    if (!run.method->draws(primitives.kindOf(index)))
        return PrimitiveRejection::NotOfThisMethod;
    const Run one(run.method, aloneOf(primitives, index), run.settings, frame.view());
    TraceOptions options;
    options.detail = TraceDetail::Rejections;
    const auto trace = one.trace(frame.view(), options);
    if (!trace || trace->primitiveCount() == 0)
        return std::nullopt;
    if (const auto rejection = trace->setUp(0).rejection)
        return decided(*rejection, primitives, index, run.scene);
    // Where a stroke is not rejected, it meets the square of a pixel.
    const bool isStroke
        = !primitives.isTriangle(index) && run.method->supports(Effect::Antialiasing);
    return isStroke ? PrimitiveRejection::BetweenSamples
                    : missOf(primitives, index, windowOf(run.scene.frame));
}

/// `frame`: one to draw in, made where it is needed.
std::optional<Rejection> newRejectionIn(const TracedScene &traced, std::size_t primitive,
                                        std::optional<FrameBuffer> &frame)
{
    const ScanTrace &trace = *traced.trace;
    if (std::ranges::binary_search(trace.rejectedPrimitives(), primitive))
        return decided(*trace.setUp(primitive).rejection, traced.primitives, primitive,
                       traced.scene);
    const bool isWhole = primitive + 1 < trace.primitiveCount() || !trace.isCut();
    if (!isWhole || !wroteNothing(trace, primitive))
        return std::nullopt;
    if (!frame)
        frame.emplace(traced.scene.frame);
    return rejectionAlone(traced, primitive, *frame);
}

std::optional<Rejection> rejectionIn(const TracedScene &traced, std::size_t primitive,
                                     std::optional<FrameBuffer> &frame)
{
    const std::lock_guard lock(traced.rejections.mutex);
    auto known = traced.rejections.known.find(primitive);
    if (known == traced.rejections.known.end())
        known = traced.rejections.known.emplace(primitive, newRejectionIn(traced, primitive, frame))
                    .first;
    return known->second;
}

} // namespace

std::optional<Rejection> rejectionOf(const TracedScene &traced, std::size_t primitive)
{
    std::optional<FrameBuffer> frame;
    return rejectionIn(traced, primitive, frame);
}

QString RejectedPrimitive::message() const
{
    return u"primitive %1 (%2): %3"_s.arg(primitive).arg(nameOf(kind), rejectionText(rejection));
}

std::vector<RejectedPrimitive> rejectedPrimitives(const SceneRun &run)
{
    const FrameBuffer frame(run.scene.frame);
    std::vector<RejectedPrimitive> rejected;
    for (std::size_t index = 0; index < run.primitives.size(); ++index) {
        if (const auto rejection = rejectionAlone(run, index, frame))
            rejected.push_back({index, run.primitives.kindOf(index), *rejection});
    }
    return rejected;
}

std::vector<RejectedPrimitive> rejectedPrimitives(const TracedScene &traced)
{
    std::optional<FrameBuffer> frame;
    std::vector<RejectedPrimitive> rejected;
    for (std::size_t index = 0; index < traced.trace->primitiveCount(); ++index) {
        if (const auto rejection = rejectionIn(traced, index, frame))
            rejected.push_back({index, traced.primitives.kindOf(index), *rejection});
    }
    return rejected;
}

} // namespace pixelplumb
