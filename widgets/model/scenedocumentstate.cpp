// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenedocument.h"

#include <algorithm>
#include <utility>

/// The states of a document: snapshots for others to work on, saved or not.
namespace pixelplumb {

namespace {

constexpr int noState = -1; ///< of the scene

} // namespace

std::shared_ptr<const Scene> SceneDocument::snapshot() const
{
    if (!m_snapshot)
        m_snapshot = std::make_shared<const Scene>(m_scene);
    return m_snapshot;
}

std::shared_ptr<const Scene> SceneDocument::currentSnapshot() const
{
    if (m_currentFrame == 0)
        return snapshot(); // results are tied to this very object
    return std::make_shared<const Scene>(sceneAtFrame(*snapshot(), m_currentFrame));
}

LatticePoint SceneDocument::atCurrentFrame(const LatticePoint &point) const
{
    return {point.x + m_way.x, point.y + m_way.y};
}

LatticePoint SceneDocument::fromCurrentFrame(const LatticePoint &place) const
{
    return {place.x - m_way.x, place.y - m_way.y};
}

void SceneDocument::setCurrentFrame(int frame)
{
    const int before = std::exchange(m_currentFrame, frame);
    followMotion();
    if (m_currentFrame != before)
        emit currentFrameChanged();
}

/// Derives the offset from a triangle at the origin, so that it is rounded like the scene's.
void SceneDocument::followMotion()
{
    Scene origin;
    origin.motion = m_scene.motion;
    origin.triangles.resize(1);
    const int last = m_scene.motion ? m_scene.motion->frames - 1 : 0;
    m_currentFrame = std::clamp(m_currentFrame, 0, last);
    m_way = sceneAtFrame(origin, m_currentFrame).triangles.front().vertices[0].position;
}

void SceneDocument::tellSceneChanged()
{
    m_snapshot.reset();
    followMotion();
    emit sceneChanged();
}

void SceneDocument::markSaved()
{
    m_undoStack.setClean();
    m_savedState = m_state;
    m_savedPending = m_pending;
    tellModified();
}

void SceneDocument::markUnsaved()
{
    m_undoStack.resetClean();
    m_savedState = noState;
    tellModified();
}

void SceneDocument::tellModified()
{
    if (isModified() == m_toldModified)
        return;
    m_toldModified = isModified();
    emit modifiedChanged(m_toldModified);
}

} // namespace pixelplumb
