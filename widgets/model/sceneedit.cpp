// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/sceneedit.h"

#include <utility>

namespace pixelplumb {

SceneEdit::SceneEdit(SceneDocument &document, const QString &text, ScenePiece before,
                     ScenePiece after, const std::optional<Drag> &drag, Of of)
    : QUndoCommand(text)
    , m_document(&document)
    , m_before(std::move(before))
    , m_after(std::move(after))
    , m_stateBefore(document.m_state)
    , m_stateAfter(of == Of::View || m_before.hasSceneOf(m_after) ? m_stateBefore
                                                                  : ++document.m_lastState)
    , m_drag(drag)
{
}

bool SceneEdit::mergeWith(const QUndoCommand *other)
{
    const auto &edit = static_cast<const SceneEdit &>(*other);
    if (edit.m_drag != m_drag)
        return false;
    m_after = edit.m_after;
    m_stateAfter = edit.m_stateAfter;
    if (m_after == m_before) { // a drag that returned changed nothing
        setObsolete(true);
        m_document->m_state = m_stateBefore;
        m_document->tellModified();
    }
    return true;
}

} // namespace pixelplumb
