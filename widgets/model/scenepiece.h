// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

/// A vertex of the document: of a primitive of the scene, or placed and waiting for its primitive.
struct VertexRef {
    static constexpr int pending = -1;
    int primitive = pending; ///< index through the triangles and the shapes, or `pending`
    int vertex = 0;

    friend bool operator==(const VertexRef &, const VertexRef &) = default;
};

/// What one edit changes of a document, as it is before or after the edit: a run of triangles, one
/// of solids, one of shapes, and everything that is small. So that a scene of a million triangles
/// is edited without a copy of it, the runs hold what differs alone.
struct ScenePiece {
    FrameSpec frame;
    ScanSettings settings;
    std::string method;
    std::size_t firstTriangle = 0; ///< where the run begins, in the scene
    std::size_t firstSolid = 0;
    std::size_t firstShape = 0;
    Primitives run; ///< in the scene's coordinates; attributes by the triangle's index in the scene
    std::vector<Solid> solids; ///< of the run
    std::optional<Camera> camera;
    Appearance appearance;
    std::optional<Motion> motion;
    HiddenPrimitives hidden;
    std::vector<Vertex> pending; ///< vertices that wait for their primitive
    std::optional<Colour> chosenColour; ///< for the next vertex alone

    /// The pending vertices become the run's last primitive.
    void completePending(PrimitiveKind kind);
    /// The run's first primitive becomes its last, or, by −1, its last its first.
    void rotate(int by);
    /// The run's only triangle becomes this one; what all triangles have is not kept of it.
    void setTriangle(const Triangle &triangle, TriangleAttributes attributes);
    /// A vertex of the run's only primitive, or one that waits.
    Vertex &vertex(const VertexRef &ref);

    /// The same set-up and the same runs: the scene does not change from one to the other.
    bool hasSceneOf(const ScenePiece &other) const;
    friend bool operator==(const ScenePiece &, const ScenePiece &) = default;
};

/// The piece of a scene without primitives: runs that end it, and what is small.
ScenePiece pieceAtEnd(const Scene &scene);
/// With one primitive, by its index through the triangles and the shapes.
ScenePiece pieceWith(const Scene &scene, std::size_t primitive);
/// With some, triangles or shapes.
ScenePiece pieceWithRun(const Scene &scene, std::size_t first, std::size_t count);
ScenePiece pieceWithSolids(const Scene &scene, std::size_t first, std::size_t count);
/// With all primitives.
ScenePiece wholePiece(const Scene &scene);

/// Whether the triangles of solids keep their order: a change of one solid leaves it where it is,
/// though another view of it may be cut into more.
bool solidsStay(const ScenePiece &before, const ScenePiece &after);

/// Puts `after` where `before` stands.
void replace(Scene &scene, const ScenePiece &before, const ScenePiece &after);

} // namespace pixelplumb
