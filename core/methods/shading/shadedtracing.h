// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/shade/shadeddrawing.h"

namespace pixelplumb {

/// Draws the triangles as the run's shading() plan says and records it. Null when options.progress
/// cancelled it.
std::unique_ptr<ScanTrace> traceShaded(ShadedMethod method, const Run &run, FrameView frame,
                                       const TraceOptions &options);

} // namespace pixelplumb
