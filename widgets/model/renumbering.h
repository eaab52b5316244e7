// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/scenepiece.h"

#include <functional>
#include <optional>

namespace pixelplumb {

/// What a vertex is called after the edit: the primitives behind those that came or went move up or
/// down, those that changed places have each other's numbers, and the vertices of one that was
/// completed, or opened again, go with it. None where the vertex went. `triangleCount`: of the
/// scene before the edit.
std::optional<VertexRef> renamed(const VertexRef &ref, std::size_t triangleCount,
                                 const ScenePiece &before, const ScenePiece &after);

/// Of a triangle, by its number before an edit, the one after it; none where the edit takes it
/// away.
using TriangleRenumbering = std::function<std::optional<std::size_t>(std::size_t)>;

} // namespace pixelplumb
