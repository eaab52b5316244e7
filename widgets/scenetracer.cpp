// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenetracer.h"

#include <QtConcurrent>

#include <atomic>
#include <chrono>
#include <new>
#include <span>
#include <utility>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto rest = 80ms; ///< more than between two moves of a hand

constexpr std::int64_t rowsOfATruthBand = 64; // traceScene asks for progress at each

TraceOutcome outcomeOf(const Scene &scene, const TraceOptions &options)
{
    try {
        return {traceScene(scene, options), {}};
    } catch (const std::bad_alloc &) {
        return {
            nullptr,
            SceneTracer::tr("The scene does not fit into memory: a frame of %1 × %2 pixels with "
                            "%3 triangles. Make the frame or the triangles smaller.")
                .arg(scene.frame.width)
                .arg(scene.frame.height)
                .arg(scene.triangles.size())};
    }
}

QString refusalOf(const Scene &scene)
{
    const QString id = QString::fromStdString(scene.method);
    const Method *method = methodNamed(id);
    return method ? method->refusal(scene.settings)
                  : SceneTracer::tr("There is no method named “%1”.").arg(id);
}

/// Done at once; looks closer only at what may be small.
bool isSmall(const Scene &scene)
{
    return std::int64_t(scene.triangles.size() + scene.shapes.size())
        <= TraceCost::mostTrianglesOfSmall
        && traceCostOf(scene).isSmall();
}

/// The least and the greatest of one coordinate.
std::pair<Lattice, Lattice> extentOf(std::span<const Vertex> vertices,
                                     Lattice LatticePoint::*coordinate, Lattice margin)
{
    Lattice least = vertices.front().position.*coordinate;
    Lattice greatest = least;
    for (const Vertex &vertex : vertices) {
        least = std::min(least, vertex.position.*coordinate);
        greatest = std::max(greatest, vertex.position.*coordinate);
    }
    return {least - margin, greatest + margin};
}

/// How far a shape reaches beyond its vertices: a circle's are its centre and one corner.
Lattice reachOf(const Shape &shape)
{
    if (shape.kind == PrimitiveKind::Text)
        return shape.textHeight * Lattice(shape.text.size());
    if (shape.kind != PrimitiveKind::Circle && shape.kind != PrimitiveKind::Ellipse)
        return 0;
    const LatticePoint &centre = shape.vertices[0].position;
    const LatticePoint &corner = shape.vertices[1].position;
    return 2 * std::max(std::abs(corner.x - centre.x), std::abs(corner.y - centre.y));
}

} // namespace

TraceCost traceCostOf(const Scene &scene)
{
    TraceCost cost;
    const FrameSpec &frame = scene.frame;
    const Lattice offset = sampleOffset(frame);
    const auto add = [&](std::span<const Vertex> vertices, Lattice margin) {
        const auto [left, right] = extentOf(vertices, &LatticePoint::x, margin);
        const auto [low, high] = extentOf(vertices, &LatticePoint::y, margin);
        const auto samples = [offset](Lattice first, Lattice last, std::int64_t frameFirst,
                                      std::int64_t frameSize) {
            const std::int64_t begin = std::max(ceilPixel(first - offset), frameFirst);
            const std::int64_t end
                = std::min(floorPixel(last - offset) + 1, frameFirst + frameSize);
            return std::max<std::int64_t>(0, end - begin);
        };
        const std::int64_t columns = samples(left, right, frame.firstColumn, frame.width);
        ++cost.triangles;
        cost.columns += columns;
        cost.pixels += columns * samples(low, high, frame.firstRow, frame.height);
    };
    for (const Triangle &triangle : scene.triangles)
        add(triangle.vertices, 0);
    for (const Shape &shape : scene.shapes)
        add(shape.vertices, reachOf(shape));
    return cost;
}

/// What the worker tells and is told while it works.
struct SceneTracer::Progress {
    std::atomic<bool> cancelled = false;
    std::atomic<std::int64_t> columnsEntered = 0;
    std::atomic<std::int64_t> bandsOfTruth = 0;
    std::atomic<std::int64_t> expectedColumns = 0; ///< none until they are counted
    std::int64_t expectedBands = 1;

    /// Heard in the worker's thread.
    bool goesOn(std::size_t entered)
    {
        // While columns are recorded, each call comes with one more; then the truth's bands follow.
        if (std::int64_t(entered) > columnsEntered)
            columnsEntered = std::int64_t(entered);
        else
            ++bandsOfTruth;
        return !cancelled;
    }
    int percent() const
    {
        if (expectedColumns == 0)
            return 0;
        const auto half = [](std::int64_t done, std::int64_t expected) {
            return int(std::min<std::int64_t>(50, 50 * done / std::max<std::int64_t>(1, expected)));
        };
        return half(columnsEntered, expectedColumns) + half(bandsOfTruth, expectedBands);
    }
};

SceneTracer::SceneTracer(QObject *parent)
    : QObject(parent)
{
    m_restTimer.setSingleShot(true);
    m_restTimer.setInterval(rest);
    connect(&m_restTimer, &QTimer::timeout, this, &SceneTracer::startNext);
    m_progressTimer.setInterval(50ms);
    connect(&m_progressTimer, &QTimer::timeout, this, &SceneTracer::tellProgress);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &SceneTracer::finish);
}

SceneTracer::~SceneTracer()
{
    if (!m_progress)
        return;
    m_progress->cancelled = true;
    m_watcher.waitForFinished();
}

bool SceneTracer::isRunning() const { return m_progress || m_next; }

void SceneTracer::trace(const Scene &scene) { trace(std::make_shared<const Scene>(scene)); }

void SceneTracer::trace(const std::shared_ptr<const Scene> &scene)
{
    if (m_progress)
        m_progress->cancelled = true;
    if (!isRunning()) {
        start(scene);
        return;
    }
    m_next = scene;
    m_restTimer.start(isSmall(*scene) ? 0ms : rest);
}

void SceneTracer::cancel()
{
    const bool isWaiting = m_next && !m_progress;
    m_next.reset();
    m_restTimer.stop();
    if (m_progress)
        m_progress->cancelled = true;
    else if (isWaiting)
        emit cancelled();
}

/// Whichever ends later, the cancelled trace or the rest, begins the next one.
void SceneTracer::startNext()
{
    if (m_next && !m_progress && !m_restTimer.isActive())
        start(std::exchange(m_next, nullptr));
}

void SceneTracer::start(const std::shared_ptr<const Scene> &scene)
{
    if (const QString refusal = refusalOf(*scene); !refusal.isEmpty()) {
        emit failed(refusal);
        return;
    }
    if (isSmall(*scene)) {
        const TraceOutcome outcome = outcomeOf(*scene, {});
        if (outcome.traced)
            emit traced(outcome.traced);
        else
            emit failed(outcome.failure);
        return;
    }
    m_progress = std::make_unique<Progress>();
    m_progress->expectedBands = scene->frame.height / rowsOfATruthBand + 1;
    m_watcher.setFuture(QtConcurrent::run([scene, progress = m_progress.get()] {
        progress->expectedColumns = std::max<std::int64_t>(1, traceCostOf(*scene).columns);
        TraceOptions options;
        options.progress = [progress](std::size_t entered) { return progress->goesOn(entered); };
        return outcomeOf(*scene, options);
    }));
    m_progressTimer.start();
    emit started();
}

void SceneTracer::finish()
{
    m_progressTimer.stop();
    // Taken, so that the watcher does not keep a large run alive beside the one that is shown.
    const TraceOutcome outcome = m_watcher.future().takeResult();
    const bool wasCancelled = m_progress->cancelled;
    m_progress.reset();
    if (m_next) {
        startNext();
        return;
    }
    if (wasCancelled)
        emit cancelled();
    else if (outcome.traced)
        emit traced(outcome.traced);
    else
        emit failed(outcome.failure);
}

void SceneTracer::tellProgress()
{
    if (m_progress)
        emit progressChanged(m_progress->percent());
}

} // namespace pixelplumb
