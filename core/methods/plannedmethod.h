// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shadedtracing.h"

/// How a method gets effects: where a scene calls for nothing beyond colour, the method's own
/// drawing and tracing run, and none of the effects' code.
namespace pixelplumb {

template <ShadedMethod method, auto plain>
void drawPlanned(const Primitives &primitives, const ScanSettings &settings, FrameView frame)
{
    if (const auto plan = planBeyondColour(primitives, settings, frame))
        drawShaded(method, primitives, settings, frame, *plan);
    else
        plain(primitives, settings, frame);
}

template <ShadedMethod method>
bool drawEffects(const Primitives &primitives, const ScanSettings &settings, FrameView frame,
                 const EffectPlan &plan, const ProgressListener &listener)
{
    return drawShaded(method, primitives, settings, frame, plan, listener).has_value();
}

template <ShadedMethod method, auto plain>
std::unique_ptr<ScanTrace> tracePlanned(const Primitives &primitives, const ScanSettings &settings,
                                        FrameView frame, const TraceOptions &options)
{
    if (const auto plan = planBeyondColour(primitives, settings, frame))
        return traceShaded(method, primitives, settings, frame, *plan, options);
    return plain(primitives, settings, frame, options);
}

} // namespace pixelplumb
