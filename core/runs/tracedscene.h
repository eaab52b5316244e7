// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/coveragemask.h"
#include "core/runs/decidedpositions.h"
#include "core/runs/scenerun.h"
#include "core/trace/tracecursor.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

namespace pixelplumb {

/// Something on the scrubber that a person wants to jump to.
enum class MarkKind {
    PartBegins, ///< the first or last span of a part; of a triangle, those at its vertices
    Tie, ///< a column or row in which a sample lies exactly on an edge; a line's half-way step
    Clamp, ///< a pixel whose level left 0 … 255
    FirstDifference, ///< the first step after which a pixel differs from the truth
};

struct TraceMark {
    std::size_t step = 0; ///< index of the step
    MarkKind kind = MarkKind::PartBegins;

    friend bool operator==(const TraceMark &, const TraceMark &) = default;
};

/// A scene's run, drawn and recorded, with the truth. A value that views receive whole and
/// never change; built outside the GUI thread.
struct TracedScene : SceneRun {
    explicit TracedScene(SceneRun run)
        : SceneRun(std::move(run))
        , truth(scene.frame)
        , differences(scene.frame)
    {
    }

    std::unique_ptr<const ScanTrace> trace;
    /// The spans of the same method in exact arithmetic; null if the trace itself is exact or the
    /// method has no exact arithmetic.
    std::unique_ptr<const ScanTrace> exactTrace;
    FrameBuffer truth; ///< the oracle's picture
    std::int64_t truePixels = 0; ///< that the truth covers
    DifferenceMap differences; ///< of the finished picture
    std::vector<TraceMark> marks; ///< ascending steps; ties and clamps at most one a span

    DecidedPositions decided;

    /// Why nothing was drawn of a primitive: rejectionOf() keeps its answers here, since each takes
    /// a drawing. Readers of several threads ask.
    struct Rejections {
        std::mutex mutex;
        std::map<std::size_t, std::optional<Rejection>> known; ///< by primitive
    };
    mutable Rejections rejections;

    /// A drawn primitive's index among the scene's triangles and shapes; none for a solid's
    /// triangle.
    std::optional<std::size_t> indexInScene(std::size_t primitive) const;

    /// The position from which a pixel's difference is decided (see DecidedPositions).
    std::size_t decidedAt(std::int64_t x, std::int64_t y) const { return decided.at(x, y); }

    struct WrongPixel {
        std::int64_t x = 0;
        std::int64_t y = 0;
        std::size_t decidedAt = 0;
    };
    /// The first to be decided, in drawing order; none if the picture is true.
    std::optional<WrongPixel> firstWrongPixel() const;
};

/// The exact values of the cells of a set-up or a span, in the same order; none where there is
/// nothing to compare.
std::vector<Quantity> exactSetUpCells(const TracedScene &traced, std::size_t primitive);
std::vector<Quantity> exactSpanCells(const TracedScene &traced, std::size_t span);
/// The exact R, G and B that a triangle interpolates at (x, y), before texture, light and blending,
/// by the truth of what the run's plan does. Inside and outside the triangle; none for a shape, and
/// beyond the horizon of the triangle's plane. Every view that shows a level as exact takes it from
/// here.
std::array<Quantity, 3> exactLevelsAt(const TracedScene &traced, std::size_t primitive,
                                      std::int64_t x, std::int64_t y);
/// The exact numbers of samples of one span.
struct ExactSample {
    std::array<Quantity, 3> colour; ///< exactLevelsAt(); none where the run has no levels there
    std::vector<Quantity> cells; ///< exact values of the sample's cells
};
std::vector<ExactSample> exactSamplesOf(const TracedScene &traced, std::size_t span,
                                        std::span<const SampleRecord> samples);

/// Null when options.progress ended it. The scene's method must be able to draw it (see
/// objectionTo).
std::shared_ptr<const TracedScene> traceScene(SceneRun run, const TraceOptions &options = {});
std::shared_ptr<const TracedScene> traceScene(const Scene &scene, const TraceOptions &options = {});

/// The picture alone, by the scene's method.
void drawScene(const Scene &scene, const FrameBuffer &frame);
/// The oracle's picture of the scene.
void drawTruth(const Scene &scene, const FrameBuffer &frame);

/// The pixels that a run writes, whatever their colours.
CoverageMask coverageOf(const SceneRun &run);
/// Those that a recorded run has written at a position.
CoverageMask coverageAt(const TracedScene &traced, std::size_t position);

} // namespace pixelplumb
