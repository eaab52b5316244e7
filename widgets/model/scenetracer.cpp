// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenetracer.h"

#include "core/runs/scenerun.h"
#include "core/scene/files/scenelimits.h"
#include "widgets/model/runnotes.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <span>
#include <utility>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

constexpr auto rest = 80ms; ///< longer than the gap between two moves of a drag
constexpr std::int64_t cornersOfLetter = 30; ///< of its outline, with curves split into pieces

/// The scene's own triangles and those of its solids, before clipping.
std::size_t trianglesOf(const Scene &scene)
{
    std::size_t count = scene.triangles.size();
    for (const Solid &solid : scene.solids)
        count += triangleCount(solid);
    return count;
}

QString tooLargeForMemory(const Scene &scene)
{
    const std::size_t triangles = trianglesOf(scene);
    return SceneTracer::tr("The scene does not fit into memory: a frame of %1 × %2 pixels with "
                           "%3. Make the frame or the triangles smaller.")
        .arg(scene.frame.width)
        .arg(scene.frame.height)
        .arg(SceneTracer::tr("%n triangles", nullptr, int(triangles)));
}

std::shared_ptr<const TracedScene> tracedOrNull(SceneRun run)
{
    try {
        return traceScene(std::move(run));
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

/// The run of a scene that is traced at once; examines only scenes that may be small.
std::optional<SceneRun> smallRunOf(const Scene &scene)
{
    if (std::int64_t(trianglesOf(scene) + scene.shapes.size()) > TraceCost::mostTrianglesOfSmall)
        return std::nullopt;
    Primitives primitives = primitivesOnSamples(scene);
    return traceCostOf(primitives, scene.frame).isSmall()
        ? std::optional<SceneRun>(std::in_place, scene, std::move(primitives))
        : std::nullopt;
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

/// How far a shape extends beyond its vertices: a circle's are its centre and one corner.
Lattice reachOf(const Shape &shape)
{
    if (shape.kind == PrimitiveKind::Text)
        return std::abs(shape.textHeight) * Lattice(shape.text.size());
    if (shape.kind != PrimitiveKind::Circle && shape.kind != PrimitiveKind::Ellipse)
        return 0;
    const LatticePoint &centre = shape.vertices[0].position;
    const LatticePoint &corner = shape.vertices[1].position;
    return 2 * std::max(std::abs(corner.x - centre.x), std::abs(corner.y - centre.y));
}

/// Pixels; larger frames are shown only once traced. Pictures take 9 bytes per pixel, and up to
/// three are in memory beside the trace.
constexpr std::int64_t largestPreview = std::int64_t(1) << 25;

} // namespace

TraceCost traceCostOf(const Primitives &primitives, const FrameSpec &frame)
{
    TraceCost cost;
    const auto add = [&](std::span<const Vertex> vertices, Lattice margin) {
        const auto [left, right] = extentOf(vertices, &LatticePoint::x, margin);
        const auto [low, high] = extentOf(vertices, &LatticePoint::y, margin);
        const auto samples
            = [](Lattice first, Lattice last, std::int64_t frameFirst, std::int64_t frameSize) {
                  const std::int64_t begin = std::max(ceilPixel(first), frameFirst);
                  const std::int64_t end = std::min(floorPixel(last) + 1, frameFirst + frameSize);
                  return std::max<std::int64_t>(0, end - begin);
              };
        const std::int64_t columns = samples(left, right, frame.firstColumn, frame.width);
        ++cost.triangles;
        cost.columns += columns;
        cost.pixels += columns * samples(low, high, frame.firstRow, frame.height);
    };
    for (const Triangle &triangle : primitives.triangles)
        add(triangle.vertices, 0);
    for (const Shape &shape : primitives.shapes) {
        add(shape.vertices, reachOf(shape));
        cost.corners += std::int64_t(shape.vertices.size())
            + cornersOfLetter * std::int64_t(shape.text.size());
    }
    return cost;
}

SceneTracer::SceneTracer(QObject *parent)
    : QObject(parent)
{
    m_job.setTitle(tr("Tracing"));
    m_job.setRest(rest);
}

void SceneTracer::trace(const Scene &scene) { trace(std::make_shared<const Scene>(scene)); }

void SceneTracer::trace(const std::shared_ptr<const Scene> &scene)
{
    const auto refuse = [this](const QString &refusal) {
        m_job.cancel();
        emit failed(refusal);
    };
    const QString id = QString::fromStdString(scene->method);
    const Method *method = methodNamed(id);
    if (!method)
        return refuse(tr("There is no method named “%1”.").arg(id));
    std::optional<SceneRun> small = smallRunOf(*scene);
    const QString objection = small ? objectionTo(*small) : objectionTo(*scene);
    if (!objection.isEmpty())
        return refuse(objectionNote(*method, objection));
    if (small) {
        m_job.cancel();
        take(*scene, tracedOrNull(std::move(*small)));
        return;
    }
    m_job.start(
        [scene](const ProgressListener &listener) -> std::shared_ptr<const TracedScene> {
            auto run = sceneRunOf(*scene, listener);
            if (!run)
                return nullptr;
            const std::int64_t expectedSpans = traceCostOf(run->primitives, scene->frame).columns;
            TraceOptions options;
            options.progress = [&listener, expectedSpans](JobProgress progress) {
                if (progress.phase == JobPhase::Recording
                    || progress.phase == JobPhase::RecordingExactly)
                    progress.total = std::max(expectedSpans, progress.done);
                return listener(progress);
            };
            return traceScene(std::move(*run), options);
        },
        [this, scene](const std::shared_ptr<const TracedScene> &outcome) {
            take(*scene, outcome);
        });
}

void SceneTracer::cancel()
{
    if (!isRunning())
        return;
    m_job.cancel();
    emit cancelled();
}

void SceneTracer::take(const Scene &scene, const std::shared_ptr<const TracedScene> &outcome)
{
    if (outcome)
        emit traced(outcome);
    else
        emit failed(tooLargeForMemory(scene));
}

ScenePreviewer::ScenePreviewer(QObject *parent)
    : QObject(parent)
    , m_job(nullptr, &m_thread)
{
    m_thread.setMaxThreadCount(1);
}

void ScenePreviewer::preview(const std::shared_ptr<const Scene> &scene)
{
    if (std::int64_t(scene->frame.width) * scene->frame.height > largestPreview) {
        clear();
        return;
    }
    m_need = Need::TraceOnTheWay;
    if (isRunning())
        m_next = scene;
    else
        start(scene);
}

void ScenePreviewer::followTrace(const std::shared_ptr<const TracedScene> &traced)
{
    if (!traced->trace->isCut()) {
        clear();
    } else if (m_need != Need::Nothing) {
        m_need = Need::TraceCut;
        emit pictureChanged();
    }
}

void ScenePreviewer::clear()
{
    const bool wasNeeded = std::exchange(m_need, Need::Nothing) != Need::Nothing;
    m_next.reset();
    m_job.cancel();
    m_pictures.clear();
    if (std::exchange(m_picture, nullptr) || wasNeeded)
        emit pictureChanged();
}

void ScenePreviewer::start(const std::shared_ptr<const Scene> &scene)
{
    // Without a picture if memory runs out; the trace will report that.
    m_job.start(
        [scene, spare = spareFor(scene->frame)](const ProgressListener &listener) {
            auto picture = spare ? spare : std::make_shared<ScenePicture>(scene->frame);
            return picture->draw(scene, listener) ? picture : nullptr;
        },
        [this](const std::shared_ptr<ScenePicture> &picture) { take(picture); });
}

void ScenePreviewer::take(const std::shared_ptr<ScenePicture> &picture)
{
    if (picture) {
        if (std::ranges::find(m_pictures, picture) == m_pictures.end())
            m_pictures.push_back(picture);
        m_picture = picture;
        emit pictureChanged();
    }
    if (m_next)
        start(std::exchange(m_next, nullptr));
}

/// A picture no longer shown; null where there is none.
std::shared_ptr<ScenePicture> ScenePreviewer::spareFor(const FrameSpec &frame)
{
    std::erase_if(m_pictures, [&frame](const auto &picture) { return picture->spec() != frame; });
    const auto spare = std::ranges::find_if(
        m_pictures, [](const auto &picture) { return picture.use_count() == 1; });
    return spare != m_pictures.end() ? *spare : nullptr;
}

} // namespace pixelplumb
