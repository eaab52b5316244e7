// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/fastroute.h"
#include "core/fast/floatstrip.h"
#include "core/fast/instructionset.h"
#include "core/fast/trianglebatch.h"
#include "core/scan/scansettings.h"

namespace pixelplumb {

/// What a batch is drawn into, and how.
struct BatchTask {
    FrameView window; ///< at least 16 columns
    ByteRounding rounding = ByteRounding::Nearest;
    /// Draws what no fast kernel can.
    void (*drawPlain)(const Triangle &triangle, const BatchTask &task) = nullptr;
    FillRule rule = FillRule::Closed;
    RouteTally *tally = nullptr;
};

/// The kernels of one instruction set.
struct FastKernels {
    /// Sets up the triangles of a batch and draws them in order.
    void (*drawBatch)(TriangleBatch &batch, const BatchTask &task);
    void (*drawFloatStrip)(const FloatStrip &strip, ByteRounding rounding, FrameView window);
};

/// The kernels for `set`, which the machine must support.
FastKernels fastKernelsFor(InstructionSet set);

} // namespace pixelplumb
