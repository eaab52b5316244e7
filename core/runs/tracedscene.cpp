// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/tracedscene.h"

#include "core/frame/keptrows.h"
#include "core/frame/pixelrows.h"
#include "core/frame/writtenframe.h"
#include "core/runs/tracemarks.h"

#include <algorithm>

namespace pixelplumb {

namespace {

constexpr std::int32_t rowsBetweenProgress = 64;

/// Calls `drawBand` for one band of the frame after another while the listener allows it.
template <class DrawBand>
bool drawByBands(FrameView frame, const ProgressListener &listener, const DrawBand &drawBand)
{
    for (std::int32_t done = 0; done < frame.height; done += rowsBetweenProgress) {
        if (!goesOn(listener, {JobPhase::Judging, done, frame.height}))
            return false;
        const std::int64_t first = frame.firstRow + done;
        drawBand(rowsOf(frame, first, std::min(first + rowsBetweenProgress, frame.endRow())));
    }
    return true;
}

/// The truth's alpha says what it covers (pixelrows.h).
DifferenceMap differencesBetween(const FrameBuffer &drawn, const CoverageMask &drawnCoverage,
                                 const FrameBuffer &truth)
{
    const FrameSpec &spec = drawn.spec();
    DifferenceMap differences(spec);
    const FrameView drawnView = drawn.view();
    const FrameView trueView = truth.view();
    for (std::int64_t y = drawnView.firstRow; y < drawnView.endRow(); ++y) {
        for (std::int64_t x = drawnView.firstColumn; x < drawnView.endColumn(); ++x) {
            const bool written = drawnCoverage.covers(x, y);
            const bool covered = qAlpha(*trueView.at(x, y)) != 0;
            if (written != covered || (written && *drawnView.at(x, y) != *trueView.at(x, y)))
                differences.set(x, y, differenceOf(written, covered));
        }
    }
    return differences;
}

/// The spans of the same run in exact arithmetic, to compare with a rounding trace. Gives up
/// silently at the limits: the exact numbers are then none.
std::unique_ptr<const ScanTrace> exactTwinOf(const TracedScene &traced, const TraceOptions &options)
{
    if (traced.settings.arithmetic == Arithmetic::Exact
        || !traced.method->supports(Arithmetic::Exact))
        return nullptr;
    ScanSettings exact = traced.settings;
    exact.arithmetic = Arithmetic::Exact;
    TraceOptions spansAlone = options;
    // Where samples depend on what their pixels held, spans alone could not give them.
    if (!traced.shading())
        spansAlone.detail = TraceDetail::Spans;
    spansAlone.progress = [&options](const JobProgress &progress) {
        return goesOn(options.progress,
                      {JobPhase::RecordingExactly, progress.done, progress.total});
    };
    const FrameBuffer unseen(traced.scene.frame);
    return Run(traced.method, traced.primitives, exact, unseen.view())
        .trace(unseen.view(), spansAlone);
}

} // namespace

std::optional<std::size_t> TracedScene::indexInScene(std::size_t primitive) const
{
    if (primitive < scene.triangles.size())
        return primitive;
    if (primitives.isTriangle(primitive))
        return std::nullopt;
    return primitive - primitives.triangles.size() + scene.triangles.size();
}

std::optional<TracedScene::WrongPixel> TracedScene::firstWrongPixel() const
{
    std::optional<WrongPixel> first;
    if (differences.total() == 0)
        return first;
    const FrameSpec &spec = scene.frame;
    for (std::int64_t y = spec.firstRow; y < std::int64_t(spec.firstRow) + spec.height; ++y) {
        const std::span<const Difference> row = differences.row(y);
        for (std::size_t column = 0; column < row.size(); ++column) {
            if (row[column] == Difference::None)
                continue;
            const std::int64_t x = spec.firstColumn + std::int64_t(column);
            const std::size_t position = decidedAt(x, y);
            if (!first || position < first->decidedAt)
                first = {x, y, position};
        }
    }
    return first;
}

std::shared_ptr<const TracedScene> traceScene(SceneRun run, const TraceOptions &options)
{
    Q_ASSERT(objectionTo(run).isEmpty());
    auto traced = std::make_shared<TracedScene>(std::move(run));
    const Scene &scene = traced->scene;
    const FrameBuffer drawn(scene.frame);
    traced->trace = traced->Run::trace(drawn.view(), options);
    if (!traced->trace)
        return nullptr;
    const ScanTrace &trace = *traced->trace;
    traced->exactTrace = exactTwinOf(*traced, options);

    const FrameView truth = traced->truth.view();
    fillTransparent(truth, scene.frame.background);
    if (!drawByBands(truth, options.progress, [&](FrameView band) { traced->drawTruth(band); }))
        return nullptr;

    traced->differences = trace.isCut()
        ? DifferenceMap(scene.frame) // an unfinished picture has not gone wrong yet
        : differencesBetween(drawn, coverageAt(*traced, trace.stepCount()), traced->truth);
    for (std::int64_t y = truth.firstRow; y < truth.endRow(); ++y) {
        std::uint32_t *const row = truth.at(truth.firstColumn, y);
        traced->truePixels
            += std::count_if(row, row + truth.width, [](QRgb pixel) { return qAlpha(pixel) != 0; });
        makeOpaque(row, truth.width);
    }
    traced->decided = {trace, traced->differences, scene.frame};
    traced->marks = marksOf(*traced);
    return traced;
}

std::shared_ptr<const TracedScene> traceScene(const Scene &scene, const TraceOptions &options)
{
    auto run = sceneRunOf(scene, options.progress);
    return run ? traceScene(std::move(*run), options) : nullptr;
}

void drawScene(const Scene &scene, const FrameBuffer &frame) { SceneRun(scene).draw(frame.view()); }

void drawTruth(const Scene &scene, const FrameBuffer &frame)
{
    SceneRun(scene).drawTruth(frame.view());
}

CoverageMask coverageOf(const SceneRun &run)
{
    const WrittenFrame frame(run.scene.frame);
    run.draw(frame.view());
    return frame.coverage();
}

CoverageMask coverageAt(const TracedScene &traced, std::size_t position)
{
    CoverageMask coverage(traced.scene.frame);
    const auto &changes = traced.trace->changes();
    const std::size_t done = traced.trace->samplesDoneAt(position);
    for (std::size_t i = 0; i < done; ++i) {
        if (changes[i].isWritten())
            coverage.cover(changes[i].x, changes[i].y);
    }
    return coverage;
}

} // namespace pixelplumb
