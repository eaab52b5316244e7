// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/scenedocument.h"

/// The states that a document goes through: a scene for others to work on, saved or not.
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

void SceneDocument::tellSceneChanged()
{
    m_snapshot.reset();
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
