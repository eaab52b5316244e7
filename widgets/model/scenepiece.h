// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <QUndoCommand>

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

/// The part of a document that one edit changes, before or after the edit: a run of triangles, one
/// of solids, one of shapes, and all small members. The runs hold only what differs, so that a
/// scene of a million triangles is edited without a copy.
struct ScenePiece {
    Scene scene; ///< of the primitives, the runs; attributes by the triangle's index in the scene
    std::size_t firstTriangle = 0; ///< the run's start in the scene
    std::size_t firstSolid = 0;
    std::size_t firstShape = 0;
    std::vector<Vertex> pending; ///< vertices that wait for their primitive
    std::optional<Colour> chosenColour; ///< for the next vertex alone

    void clearRun(); ///< of triangles or shapes
    /// Makes the pending vertices the run's last primitive.
    void completePending(PrimitiveKind kind);
    /// Moves the run's first primitive to its end, or, with −1, its last to the front.
    void rotate(int by);
    /// Replaces the run's only triangle; attributes equal to the defaults are not stored.
    void setTriangle(const Triangle &triangle, TriangleAttributes attributes);
    /// A vertex of the run's only primitive, or a pending one.
    Vertex &vertex(const VertexRef &ref);

    /// Whether the set-up and the runs are equal: the scene is the same before and after.
    bool hasSceneOf(const ScenePiece &other) const { return scene == other.scene; }
    friend bool operator==(const ScenePiece &, const ScenePiece &) = default;
};

/// The piece without primitives: empty runs at the scene's end, and the small members.
ScenePiece pieceAtEnd(const Scene &scene);
/// The piece with one primitive, by its index through the triangles and the shapes.
ScenePiece pieceWith(const Scene &scene, std::size_t primitive);
/// The piece with a run of primitives, all triangles or all shapes.
ScenePiece pieceWithRun(const Scene &scene, std::size_t first, std::size_t count);
ScenePiece pieceWithSolids(const Scene &scene, std::size_t first, std::size_t count);
/// The piece with all primitives.
ScenePiece wholePiece(const Scene &scene);

/// Replaces `before` by `after` in the scene.
void replace(Scene &scene, const ScenePiece &before, const ScenePiece &after);

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

    void redo() override;
    void undo() override;
    /// Whether only pending vertices change.
    bool keepsScene() const { return m_before.hasSceneOf(m_after); }
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
