// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/rejectedprimitives.h"

#include "core/frame/framebuffer.h"
#include "core/methods/rejectiontext.h"

namespace pixelplumb {

namespace {

Primitives alone(const Primitives &primitives, std::size_t index)
{
    Primitives one;
    one.appearance = primitives.appearance;
    if (!primitives.isTriangle(index)) {
        one.shapes = {primitives.shape(index)};
        return one;
    }
    one.triangles = {primitives.triangles[index]};
    if (const TriangleAttributes *attributes = primitives.attributesOf(index)) {
        one.attributes = {*attributes};
        one.attributes[0].triangle = 0;
    }
    return one;
}

} // namespace

QString RejectedPrimitive::message() const
{
    return QStringLiteral("primitive %1 (%2): %3")
        .arg(primitive)
        .arg(nameOf(kind), rejectionText(rejection));
}

std::vector<RejectedPrimitive> rejectedPrimitives(const Scene &scene)
{
    const Method &method = *methodNamed(QString::fromStdString(scene.method));
    const Primitives primitives = primitivesOnSamples(scene);
    const FrameBuffer frame(scene.frame);
    std::vector<RejectedPrimitive> rejected;
    TraceOptions untilTheFirstSpan;
    untilTheFirstSpan.detail = TraceDetail::Spans;
    untilTheFirstSpan.progress = [](const JobProgress &) { return false; };
    for (std::size_t index = 0; index < primitives.size(); ++index) {
        const PrimitiveKind kind = primitives.kindOf(index);
        if (!method.draws(kind)) {
            rejected.push_back({index, kind, PrimitiveRejection::NotOfThisMethod});
            continue;
        }
        // Cancelled, and so null, where a span was entered.
        const auto trace = method.trace(alone(primitives, index), scene.settings, frame.view(),
                                        untilTheFirstSpan);
        if (!trace || trace->primitiveCount() == 0)
            continue;
        if (const auto rejection = trace->setUp(0).rejection)
            rejected.push_back({index, kind, *rejection});
    }
    return rejected;
}

std::vector<RejectedPrimitive> rejectedPrimitives(const Primitives &primitives,
                                                  const ScanTrace &trace)
{
    std::vector<RejectedPrimitive> rejected;
    for (const std::size_t index : trace.rejectedPrimitives())
        rejected.push_back({index, primitives.kindOf(index), *trace.setUp(index).rejection});
    return rejected;
}

} // namespace pixelplumb
