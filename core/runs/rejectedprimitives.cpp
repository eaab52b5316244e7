// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/rejectedprimitives.h"

#include "core/effects/framereach.h"
#include "core/effects/requirements.h"
#include "core/frame/framebuffer.h"
#include "core/methods/rejectiontext.h"
#include "core/runs/contender.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Whether nothing was written of a primitive that was recorded whole.
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

SampledFrame drawnSamplesOf(const Primitives &primitives, const Scene &scene)
{
    const FrameView frame = windowOf(scene.frame);
    return {frame, scene.settings.fillRule,
            triangleAntialiasing(primitives, scene.settings, frame)};
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
    const SampledFrame where = drawnSamplesOf(primitives, scene);
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
        const Primitives one = aloneOf(primitives, index);
        // Cancelled, and so null, where a span was entered.
        auto trace = method.trace(one, scene.settings, frame.view(), untilTheFirstSpan);
        if (!trace && primitives.isTriangle(index) && reachOf(one.triangles[0], where).isEmpty()) {
            trace = method.trace(one, scene.settings, frame.view(), {});
            if (!trace->isCut() && wroteNothing(*trace, 0))
                rejected.push_back({index, kind, PrimitiveRejection::OutsideFrame});
            continue;
        }
        if (!trace || trace->primitiveCount() == 0)
            continue;
        if (const auto rejection = trace->setUp(0).rejection)
            rejected.push_back({index, kind, *rejection});
    }
    return rejected;
}

std::vector<RejectedPrimitive> rejectedPrimitives(const TracedScene &traced)
{
    const Primitives &primitives = traced.primitives;
    const ScanTrace &trace = *traced.trace;
    const SampledFrame where = drawnSamplesOf(primitives, traced.scene);
    const auto liesBetween = [&](std::size_t triangle) {
        return reachOf(primitives.triangles[triangle], where).isEmpty()
            && wroteNothing(trace, triangle);
    };
    std::vector<RejectedPrimitive> rejected;
    const std::size_t whole = trace.primitiveCount() - (trace.isCut() ? 1 : 0);
    for (std::size_t index = 0; index < trace.primitiveCount(); ++index) {
        if (std::ranges::binary_search(trace.rejectedPrimitives(), index))
            rejected.push_back({index, primitives.kindOf(index), *trace.setUp(index).rejection});
        else if (index < whole && primitives.isTriangle(index) && liesBetween(index))
            rejected.push_back({index, PrimitiveKind::Triangle, PrimitiveRejection::OutsideFrame});
    }
    return rejected;
}

} // namespace pixelplumb
