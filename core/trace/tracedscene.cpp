// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trace/tracedscene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

const Method &methodOf(const Scene &scene)
{
    const Method *method = methodNamed(QString::fromStdString(scene.method));
    Q_ASSERT(method && method->refusal(scene.settings).isEmpty());
    return *method;
}

/// The rows [firstRow, firstRow + height) of a frame.
FrameView bandOf(FrameView frame, std::int32_t firstRow, std::int32_t height)
{
    frame.base += std::ptrdiff_t(firstRow - frame.firstRow) * frame.stride;
    frame.firstRow = firstRow;
    frame.height = height;
    return frame;
}

constexpr std::int32_t rowsBetweenProgress = 64;

/// Calls `drawBand` for one band of the frame after another while `goesOn` allows it.
template <class GoesOn, class DrawBand>
bool drawByBands(FrameView frame, const GoesOn &goesOn, const DrawBand &drawBand)
{
    for (std::int32_t done = 0; done < frame.height; done += rowsBetweenProgress) {
        if (!goesOn())
            return false;
        drawBand(bandOf(frame, frame.firstRow + done,
                        std::min(rowsBetweenProgress, frame.height - done)));
    }
    return true;
}

CoverageMask coverageOf(const ScanTrace &trace, const FrameSpec &spec)
{
    CoverageMask coverage(spec);
    for (std::size_t i = 0; i < trace.pixelCount(); ++i)
        coverage.cover(trace.changes()[i].x, trace.changes()[i].y);
    return coverage;
}

DifferenceMap differencesBetween(const FrameBuffer &drawn, const CoverageMask &drawnCoverage,
                                 const FrameBuffer &truth, const CoverageMask &trueCoverage)
{
    const FrameSpec &spec = drawn.spec();
    DifferenceMap differences(spec);
    const FrameView drawnView = drawn.view();
    const FrameView trueView = truth.view();
    for (std::int64_t y = drawnView.firstRow; y < drawnView.endRow(); ++y) {
        for (std::int64_t x = drawnView.firstColumn; x < drawnView.endColumn(); ++x) {
            const bool written = drawnCoverage.covers(x, y);
            const bool covered = trueCoverage.covers(x, y);
            if (covered && !written)
                differences.set(x, y, Difference::Missing);
            else if (written && !covered)
                differences.set(x, y, Difference::Extra);
            else if (written && *drawnView.at(x, y) != *trueView.at(x, y))
                differences.set(x, y, Difference::Colour);
        }
    }
    return differences;
}

std::vector<std::size_t> decidedPositionsOf(const ScanTrace &trace, const FrameSpec &spec)
{
    // A column that the kernel never entered is decided when everything is drawn.
    std::vector<std::size_t> decided(std::size_t(spec.width), 0);
    for (std::size_t column = 0; column < trace.columnCount(); ++column) {
        const std::size_t end = trace.indexOfColumn(column) + 1 + trace.endPixelOf(column)
            - trace.firstPixelOf(column);
        decided[std::size_t(trace.xOf(column) - spec.firstColumn)] = end;
    }
    std::ranges::replace(decided, std::size_t(0), trace.stepCount());
    return decided;
}

/// The step after which the first wrong pixel stands in the frame.
std::optional<std::size_t> firstDifferenceOf(const TracedScene &traced)
{
    if (traced.differences.total() == 0)
        return std::nullopt;
    const ScanTrace &trace = *traced.trace;
    std::size_t first = trace.stepCount() - 1;
    for (std::size_t pixel = 0; pixel < trace.pixelCount(); ++pixel) {
        const PixelChange &change = trace.changes()[pixel];
        const Difference kind = traced.differences.at(change.x, change.y);
        if (kind == Difference::Extra || kind == Difference::Colour) {
            first = trace.indexOfPixel(pixel);
            break;
        }
    }
    if (traced.differences.count(Difference::Missing) == 0)
        return first;
    const FrameSpec &spec = traced.scene.frame;
    for (std::int64_t column = 0; column < spec.width; ++column) {
        const std::int64_t x = spec.firstColumn + column;
        const std::size_t decided = traced.decidedAt(x);
        if (decided == 0 || decided - 1 >= first)
            continue;
        for (std::int64_t y = spec.firstRow; y < std::int64_t(spec.firstRow) + spec.height; ++y) {
            if (traced.differences.at(x, y) == Difference::Missing) {
                first = decided - 1;
                break;
            }
        }
    }
    return first;
}

std::vector<TraceMark> marksOf(const TracedScene &traced)
{
    const ScanTrace &trace = *traced.trace;
    std::vector<TraceMark> marks;
    for (std::size_t triangle = 0; triangle < trace.triangleCount(); ++triangle) {
        const std::size_t first = trace.firstColumnOf(triangle);
        const std::size_t end = trace.endColumnOf(triangle);
        ColumnHalf half = ColumnHalf::First;
        for (std::size_t column = first; column < end; ++column) {
            const bool secondBegins = trace.halfOf(column) != half;
            half = trace.halfOf(column);
            if (column == first || secondBegins || column + 1 == end)
                marks.push_back({trace.indexOfColumn(column), MarkKind::VertexColumn});
            if (oracle::hasTie(traced.triangles[triangle], trace.xOf(column)))
                marks.push_back({trace.indexOfColumn(column), MarkKind::Tie});
        }
    }
    std::optional<std::size_t> lastClampColumn;
    for (const std::size_t pixel : trace.clampedPixels()) {
        const std::size_t column = trace.columnOf(pixel);
        if (lastClampColumn != column)
            marks.push_back({trace.indexOfPixel(pixel), MarkKind::Clamp});
        lastClampColumn = column;
    }
    if (const std::optional<std::size_t> step = firstDifferenceOf(traced))
        marks.push_back({*step, MarkKind::FirstDifference});
    std::ranges::stable_sort(marks, {}, &TraceMark::step);
    return marks;
}

} // namespace

std::size_t TracedScene::decidedAt(std::int64_t x) const
{
    const std::int64_t column = x - scene.frame.firstColumn;
    if (column < 0 || column >= std::int64_t(decidedPositions.size()))
        return trace->stepCount();
    return decidedPositions[std::size_t(column)];
}

std::shared_ptr<const TracedScene> traceScene(const Scene &scene, const TraceOptions &options)
{
    const std::vector<Triangle> triangles = trianglesOnSamples(scene);
    const Method &method = methodOf(scene);
    FrameBuffer drawn(scene.frame);
    std::unique_ptr<const ScanTrace> trace
        = method.trace(triangles, scene.settings, drawn.view(), options);
    if (!trace)
        return nullptr;

    FrameBuffer truth(scene.frame);
    CoverageMask trueCoverage(scene.frame);
    const auto goesOn = [&] { return !options.progress || options.progress(trace->columnCount()); };
    const auto drawBand = [&](FrameView band) {
        for (const Triangle &triangle : triangles)
            oracle::draw(triangle, scene.settings.fillRule, scene.settings.rounding, band,
                         trueCoverage);
    };
    if (!drawByBands(truth.view(), goesOn, drawBand))
        return nullptr;

    const CoverageMask drawnCoverage = coverageOf(*trace, scene.frame);
    DifferenceMap differences = trace->isCut()
        ? DifferenceMap(scene.frame) // an unfinished picture has not gone wrong yet
        : differencesBetween(drawn, drawnCoverage, truth, trueCoverage);
    auto traced = std::make_shared<TracedScene>(TracedScene{scene,
                                                            triangles,
                                                            &method,
                                                            std::move(trace),
                                                            std::move(truth),
                                                            std::move(differences),
                                                            {},
                                                            {}});
    traced->decidedPositions = decidedPositionsOf(*traced->trace, scene.frame);
    traced->marks = marksOf(*traced);
    return traced;
}

void drawScene(const Scene &scene, const FrameBuffer &frame)
{
    const Method &method = methodOf(scene);
    const auto draw = method.drawFast ? method.drawFast : method.draw;
    draw(trianglesOnSamples(scene), scene.settings, frame.view());
}

void drawTruth(const Scene &scene, const FrameBuffer &frame)
{
    CoverageMask coverage(scene.frame);
    for (const Triangle &triangle : trianglesOnSamples(scene))
        oracle::draw(triangle, scene.settings.fillRule, scene.settings.rounding, frame.view(),
                     coverage);
}

} // namespace pixelplumb
