// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/runs/scenepicture.h"

#include "core/frame/keptrows.h"
#include "core/frame/pixelrows.h"
#include "core/runs/redrawnrows.h"
#include "core/runs/scenerun.h"
#include "core/scan/walks/columndrawing.h"

#include <algorithm>

namespace pixelplumb {

ScenePicture::ScenePicture(const FrameSpec &frame)
    : m_drawn(frame)
    , m_differences(frame)
{
}

const FrameBuffer *ScenePicture::exactTwin() const
{
    switch (m_twinKind) {
    case Twin::Itself:
        return &m_drawn;
    case Twin::Drawn:
        return m_twin.get();
    case Twin::None:
        break;
    }
    return nullptr;
}

ScenePicture::Twin ScenePicture::twinOf(const Scene &scene, const Method &method)
{
    if (method.isStableUnder(scene.settings))
        return Twin::Itself;
    const bool drawsShapes = std::ranges::any_of(
        scene.shapes, [&method](const Shape &shape) { return method.draws(shape); });
    const bool isKept = methodNamed(u"column-scan")->supports(scene.settings.fillRule);
    return method.draws(PrimitiveKind::Triangle) && isKept && !drawsShapes ? Twin::Drawn
                                                                           : Twin::None;
}

bool ScenePicture::draw(const std::shared_ptr<const Scene> &scene, const ProgressListener &listener)
{
    m_method = methodNamed(QString::fromStdString(scene->method));
    Q_ASSERT(m_method && objectionTo(*scene).isEmpty());
    Q_ASSERT(scene->frame == spec());
    const FrameRows rows = rowsToDraw(*scene);
    m_twinKind = twinOf(*scene, *m_method);
    m_scene.reset();
    if (m_twinKind == Twin::Drawn && !m_twin)
        m_twin = std::make_unique<FrameBuffer>(spec());
    if (rows == allRowsOf(spec())) {
        clear(rows);
        if (!drawAll(*scene, listener))
            return false;
    } else if (rows.first < rows.end && !drawRows(rows, *scene, listener)) {
        return false;
    }
    compareRows(rows);
    if (isDrawnByRows(*scene, *m_method))
        m_scene = scene;
    return true;
}

/// The rows that differ from the current picture.
FrameRows ScenePicture::rowsToDraw(const Scene &scene) const
{
    const bool knowsRows = m_scene && isDrawnByRows(scene, *m_method);
    return knowsRows ? rowsThatDiffer(scene, *m_scene) : allRowsOf(spec());
}

bool ScenePicture::drawAll(const Scene &scene, const ProgressListener &listener)
{
    auto primitives = primitivesOnSamples(scene, listener);
    return primitives && drawBoth(std::move(*primitives), scene.settings, listener);
}

/// Draws the triangles that may reach into the rows, and restores what they paint outside: in a
/// window of only these rows, rounded increments would start afresh at its first row.
bool ScenePicture::drawRows(FrameRows rows, const Scene &scene, const ProgressListener &listener)
{
    Primitives drawn;
    const Lattice offset = sampleOffset(scene.frame);
    FrameRows painted = rows;
    for (const Triangle &each : scene.triangles) {
        const Triangle triangle = onSamples(each, offset);
        const FrameRows reached = rowsReachedBy(triangle);
        if (reached.end <= rows.first || reached.first >= rows.end)
            continue;
        painted = {std::min(painted.first, reached.first), std::max(painted.end, reached.end)};
        drawn.triangles.push_back(triangle);
    }
    const FrameRows all = allRowsOf(spec());
    painted = {std::max(painted.first, all.first), std::min(painted.end, all.end)};
    std::vector<KeptRows> kept;
    for (const FrameBuffer *frame : frames()) {
        kept.emplace_back(rowsOf(frame->view(), painted.first, rows.first));
        kept.emplace_back(rowsOf(frame->view(), rows.end, painted.end));
    }
    clear(rows);
    const bool isComplete = drawBoth(std::move(drawn), scene.settings, listener);
    for (const KeptRows &each : kept)
        each.putBack();
    return isComplete;
}

/// Draws the picture, and then its exact twin where there is one.
bool ScenePicture::drawBoth(Primitives primitives, const ScanSettings &settings,
                            const ProgressListener &listener)
{
    const auto pictures = std::int64_t(frames().size());
    std::int64_t drawn = 0;
    const auto tell = [&](const JobProgress &progress) {
        return goesOn(
            listener,
            {progress.phase, progress.done + drawn * progress.total, pictures * progress.total});
    };
    Run run(m_method, std::move(primitives), settings, m_drawn.view());
    if (!run.draw(m_drawn.view(), tell))
        return false;
    if (++drawn == pictures)
        return true;
    const ScanSettings exact{Arithmetic::Exact, settings.fillRule, settings.rounding};
    return Run(methodNamed(u"column-scan"), std::move(run.primitives), exact, m_twin->view())
        .draw(m_twin->view(), tell);
}

/// The frames that are drawn into.
std::vector<const FrameBuffer *> ScenePicture::frames() const
{
    std::vector<const FrameBuffer *> frames = {&m_drawn};
    if (m_twinKind == Twin::Drawn)
        frames.push_back(m_twin.get());
    return frames;
}

void ScenePicture::clear(FrameRows rows)
{
    for (const FrameBuffer *frame : frames())
        fillTransparent(rowsOf(frame->view(), rows.first, rows.end), spec().background);
}

/// Notes what differs and makes the background opaque, in one pass over the frames.
void ScenePicture::compareRows(FrameRows rows)
{
    const FrameView drawn = m_drawn.view();
    for (std::int64_t y = rows.first; y < rows.end; ++y) {
        forgetDifferences(y);
        QRgb *const drawnRow = drawn.at(drawn.firstColumn, y);
        if (m_twinKind == Twin::Drawn) {
            QRgb *const twinRow = m_twin->view().at(drawn.firstColumn, y);
            if (!areSame(drawnRow, twinRow, drawn.width))
                noteDifferences(y, drawnRow, twinRow);
            makeOpaque(twinRow, drawn.width);
        }
        makeOpaque(drawnRow, drawn.width);
    }
}

void ScenePicture::forgetDifferences(std::int64_t y)
{
    if (m_differences.total() == 0)
        return;
    const std::span<const Difference> row = m_differences.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
        if (row[x] != Difference::None)
            m_differences.set(spec().firstColumn + std::int64_t(x), y, Difference::None);
    }
}

void ScenePicture::noteDifferences(std::int64_t y, const QRgb *drawnRow, const QRgb *twinRow)
{
    for (std::int32_t x = 0; x < spec().width; ++x) {
        if (drawnRow[x] != twinRow[x])
            m_differences.set(std::int64_t(spec().firstColumn) + x, y,
                              differenceOf(qAlpha(drawnRow[x]) != 0, qAlpha(twinRow[x]) != 0));
    }
}

} // namespace pixelplumb
