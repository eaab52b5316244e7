// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/trace/differencemap.h"
#include "core/trace/tracecursor.h"

#include <memory>
#include <optional>

namespace pixelplumb {

/// Something on the scrubber that a person wants to jump to.
enum class MarkKind {
    VertexColumn, ///< the first column at or after a vertex
    Tie, ///< a column in which a sample lies exactly on an edge
    Clamp, ///< a pixel whose level left 0 … 255
    FirstDifference, ///< the first step after which a pixel differs from the truth
};

struct TraceMark {
    std::size_t step = 0; ///< index of the step
    MarkKind kind = MarkKind::VertexColumn;

    friend bool operator==(const TraceMark &, const TraceMark &) = default;
};

/// A scene, drawn and recorded by its method, beside the truth. A value that views receive whole
/// and never change; built beside the GUI thread.
struct TracedScene {
    Scene scene;
    std::vector<Triangle> triangles; ///< in sample coordinates: what the kernel was given
    const Method *method = nullptr;
    std::unique_ptr<const ScanTrace> trace;
    FrameBuffer truth; ///< the oracle's picture
    DifferenceMap differences; ///< of the finished picture
    std::vector<TraceMark> marks; ///< ascending steps; ties and clamps at most one a column

    /// The position from which on a pixel's difference is decided: the end of the last column at
    /// its x.
    std::size_t decidedAt(std::int64_t x) const;

    std::vector<std::size_t> decidedPositions; ///< by x − firstColumn
};

/// Null when options.progress cancelled it. The scene's method must accept its settings (see
/// Method::refusal); progress counts columns entered.
std::shared_ptr<const TracedScene> traceScene(const Scene &scene, const TraceOptions &options = {});

/// The picture alone, by the scene's method.
void drawScene(const Scene &scene, const FrameBuffer &frame);
/// The oracle's picture of the scene.
void drawTruth(const Scene &scene, const FrameBuffer &frame);

} // namespace pixelplumb
