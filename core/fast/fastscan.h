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
    /// The most threads; 0: as many as the machine has. None is started for work that takes less
    /// time than starting it.
    int threads = 0;
    /// None: the best that the machine has.
    std::optional<InstructionSet> instructionSet;
};

/// One route, and how many triangles took it.
struct FastRouteUse {
    FastKernel kernel = FastKernel::None;
    ColourWord word = ColourWord::Other;
    FastReason reason = FastReason::OutsideFrame;
    std::uint64_t triangles = 0; ///< counted in each band of the frame that they touch

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
/// bit like the plain kernel under its fill rules (closed, half-open-column, open) and in every
/// arithmetic. The lanes of vectors hold columns, so a row of sixteen columns is one store; many
/// triangles are set up at once; in exact arithmetic several threads draw bands of rows, and even
/// one thread draws a frame in bands if no cache holds it. The plain kernel draws what no fast
/// kernel covers.
FastReport drawFast(std::span<const Triangle> triangles, const ScanSettings &settings,
                    FrameView frame, const FastOptions &options = {});

} // namespace pixelplumb
