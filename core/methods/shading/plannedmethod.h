// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/shade/shadeddrawing.h"

/// How a method gets effects: where a scene calls for nothing beyond colour, the method's own
/// drawing and tracing run, and none of the effects' code.
namespace pixelplumb {

/// Draws the triangles as the run's shading() plan says and records it. Null when options.progress
/// cancelled it.
std::unique_ptr<ScanTrace> traceShaded(ShadedMethod method, const Run &run, FrameView frame,
                                       const TraceOptions &options);

template <ShadedMethod method, auto plain>
bool drawPlanned(const Run &run, FrameView frame, const ProgressListener &listener)
{
    if (const EffectPlan *plan = run.shading())
        return drawShaded(method, run.primitives, run.settings, frame, *plan, listener).has_value();
    return plain(run, frame, listener);
}

template <ShadedMethod method, auto plain>
std::unique_ptr<ScanTrace> tracePlanned(const Run &run, FrameView frame,
                                        const TraceOptions &options)
{
    return run.shading() ? traceShaded(method, run, frame, options) : plain(run, frame, options);
}

} // namespace pixelplumb
