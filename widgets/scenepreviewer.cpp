// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenepreviewer.h"

#include "core/trace/tracedscene.h"

#include <QtConcurrent>

#include <algorithm>
#include <new>
#include <utility>

namespace pixelplumb {

namespace {

/// Pixels; larger frames are shown when they have been traced. Pictures take 9 bytes a pixel, and
/// up to three of them are in memory beside the trace.
constexpr std::int64_t largestPreview = std::int64_t(1) << 25;

} // namespace

ScenePreviewer::ScenePreviewer(QObject *parent)
    : QObject(parent)
{
    m_thread.setMaxThreadCount(1);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &ScenePreviewer::finish);
}

ScenePreviewer::~ScenePreviewer()
{
    m_cancelled = true;
    if (m_isRunning) // a future that never was does not finish
        m_watcher.waitForFinished();
}

void ScenePreviewer::preview(const std::shared_ptr<const Scene> &scene)
{
    if (std::int64_t(scene->frame.width) * scene->frame.height > largestPreview) {
        clear();
        return;
    }
    m_need = Need::TraceOnTheWay;
    if (m_isRunning)
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
    m_need = Need::Nothing;
    m_next.reset();
    m_cancelled = true;
    m_pictures.clear();
    if (std::exchange(m_picture, nullptr))
        emit pictureChanged();
}

void ScenePreviewer::start(const std::shared_ptr<const Scene> &scene)
{
    m_isRunning = true;
    m_cancelled = false;
    m_watcher.setFuture(QtConcurrent::run(
        &m_thread,
        [scene, picture = spareFor(scene->frame), this]() -> std::shared_ptr<ScenePicture> {
            try {
                const auto drawn = picture ? picture : std::make_shared<ScenePicture>(scene->frame);
                return drawn->draw(scene, [this] { return !m_cancelled; }) ? drawn : nullptr;
            } catch (const std::bad_alloc &) {
                return nullptr; // the trace will tell that memory ran out
            }
        }));
}

void ScenePreviewer::finish()
{
    const std::shared_ptr<ScenePicture> picture = m_watcher.future().takeResult();
    m_isRunning = false;
    if (picture && !m_cancelled) {
        if (std::ranges::find(m_pictures, picture) == m_pictures.end())
            m_pictures.push_back(picture);
        m_picture = picture;
        emit pictureChanged();
    }
    if (m_next)
        start(std::exchange(m_next, nullptr));
}

/// A picture that nobody shows any more; null where there is none.
std::shared_ptr<ScenePicture> ScenePreviewer::spareFor(const FrameSpec &frame)
{
    std::erase_if(m_pictures, [&frame](const auto &picture) { return picture->spec() != frame; });
    const auto spare = std::ranges::find_if(
        m_pictures, [](const auto &picture) { return picture.use_count() == 1; });
    return spare != m_pictures.end() ? *spare : nullptr;
}

} // namespace pixelplumb
