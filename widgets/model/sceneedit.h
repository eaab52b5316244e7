// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QUndoCommand>

#include <memory>
#include <optional>

namespace pixelplumb {

class SceneDocument;

/// A vertex of the document: of a primitive of the scene, or pending.
struct VertexRef {
    static constexpr int pending = -1;
    int primitive = pending; ///< index through the triangles and the shapes, or `pending`
    int vertex = 0;

    friend bool operator==(const VertexRef &, const VertexRef &) = default;
};

/// A document at one moment. The scene is immutable: steps of undo and worker threads share it.
struct DocumentState {
    std::shared_ptr<const Scene> scene = std::make_shared<const Scene>();
    std::vector<Vertex> pending; ///< vertices that wait for their primitive
    std::optional<Colour> chosenColour; ///< for the next vertex alone
    int number = 0; ///< of the scene; a change of pending vertices or of the view keeps it

    /// Replaces the scene by a copy of it, to be changed at once.
    Scene &changedScene();
    Vertex &changedVertex(const VertexRef &ref);

    /// Whatever the number.
    friend bool operator==(const DocumentState &a, const DocumentState &b)
    {
        return (a.scene == b.scene || *a.scene == *b.scene) && a.pending == b.pending
            && a.chosenColour == b.chosenColour;
    }
};

/// The new reference to a vertex after an edit. Primitives after inserted or removed ones are
/// renumbered, moved ones take their numbers along, and the vertices of a primitive that was
/// completed, or opened again, go with it. None where the vertex was removed.
std::optional<VertexRef> renamed(const VertexRef &ref, const DocumentState &before,
                                 const DocumentState &after);

/// Takes a primitive out of those drawn, by its number; with its place among the triangles or
/// shapes.
HiddenPrimitive take(Scene &scene, int primitive);
/// Adds a primitive to those drawn, at its place.
void insert(Scene &scene, const HiddenPrimitive &primitive);

/// Whether a primitive is painted in one colour, that of its first vertex. A document gives it to
/// all of its vertices, so that their handles have the visible colour.
constexpr bool hasOneColour(PrimitiveKind kind)
{
    return kind != PrimitiveKind::Triangle && kind != PrimitiveKind::Point
        && kind != PrimitiveKind::Line;
}

/// The moves of a vertex in one drag, or while a key repeats.
struct Drag {
    VertexRef ref;
    int number = 0; ///< unique to the drag

    friend bool operator==(const Drag &, const Drag &) = default;
};

/// Any change of a document: its states before and after.
class SceneEdit final : public QUndoCommand {
public:
    /// Edits with the same drag merge into one.
    SceneEdit(SceneDocument &document, const QString &text, DocumentState before,
              DocumentState after, const std::optional<Drag> &drag);

    void redo() override;
    void undo() override;
    /// Whether only pending vertices change.
    bool keepsScene() const { return m_before.scene == m_after.scene; }
    int id() const override { return m_drag ? 1 : -1; }
    bool mergeWith(const QUndoCommand *other) override;

private:
    SceneDocument *m_document;
    DocumentState m_before;
    DocumentState m_after;
    std::optional<Drag> m_drag;
};

} // namespace pixelplumb
