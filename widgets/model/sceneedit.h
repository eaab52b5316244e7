// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenedocument.h"

#include <QUndoCommand>

namespace pixelplumb {

/// The moves of a vertex in one drag, or while a key repeats.
struct Drag {
    VertexRef ref;
    int number = 0; ///< unique to the drag

    friend bool operator==(const Drag &, const Drag &) = default;
};

/// Any change of a document, as a piece of it before and after.
class SceneEdit final : public QUndoCommand {
public:
    /// What closing without saving would lose: a change of the scene, or only another view of it,
    /// by another method and the settings that it supports.
    enum class Of { Scene, View };

    /// Edits with the same drag merge into one.
    SceneEdit(SceneDocument &document, const QString &text, ScenePiece before, ScenePiece after,
              const std::optional<Drag> &drag = std::nullopt, Of of = Of::Scene);

    void redo() override { m_document->exchange(m_before, m_after, m_stateAfter); }
    void undo() override { m_document->exchange(m_after, m_before, m_stateBefore); }
    bool keepsScene() const
    {
        return m_before.hasSceneOf(m_after);
    } ///< only pending vertices
      ///< change
    int id() const override { return m_drag ? 1 : -1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    SceneDocument *m_document;
    ScenePiece m_before;
    ScenePiece m_after;
    int m_stateBefore;
    int m_stateAfter;
    std::optional<Drag> m_drag;
};

} // namespace pixelplumb
