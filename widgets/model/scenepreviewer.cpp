// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenepreviewer.h"

#include "core/runs/tracedscene.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// Pixels; larger frames are shown only once traced. Pictures take 9 bytes per pixel, and up to
/// three are in memory beside the trace.
constexpr std::int64_t largestPreview = std::int64_t(1) << 25;

} // namespace

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
