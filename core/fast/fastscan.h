// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fast/fastroute.h"
#include "core/fast/instructionset.h"
#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"
#include "core/scan/scansettings.h"

#include <optional>
#include <span>
#include <vector>

namespace pixelplumb {

/// How the fast path may use the machine. The picture does not depend on it.
struct FastOptions {
    /// Threads at most; 0: as many as the machine has. None is started for what takes less time
    /// than its start.
    int threads = 0;
    /// Nothing: the best that the machine has.
    std::optional<InstructionSet> instructionSet;
};

/// One way that triangles went.
struct FastRouteUse {
    FastKernel kernel = FastKernel::None;
    ColourWord word = ColourWord::Other;
    FastReason reason = FastReason::OutsideFrame;
    std::uint64_t triangles = 0; ///< in each band of the frame that they touch

    friend bool operator==(const FastRouteUse &, const FastRouteUse &) = default;
};

/// What the fast path did.
struct FastReport {
    InstructionSet instructionSet = InstructionSet::Scalar;
    int threads = 1;
    int bands = 1; ///< parts of the frame, each drawn by one thread
    std::vector<FastRouteUse> uses; ///< by kernel, word and reason
};

/// The column scan as fast as memory allows: draws triangles (sample coordinates) in order, bit for
/// bit the plain kernel's picture under its fill rules (closed, half-open-column, open) and every
/// arithmetic. Columns stand in the lanes of vectors, so that a row of sixteen columns is one
/// store; set-up is done for many triangles at once; in exact arithmetic bands of rows are drawn by
/// several threads, and of a frame that no cache holds by one. What no fast kernel covers, the
/// plain one draws.
FastReport drawFast(std::span<const Triangle> triangles, const ScanSettings &settings,
                    FrameView frame, const FastOptions &options = {});

} // namespace pixelplumb
