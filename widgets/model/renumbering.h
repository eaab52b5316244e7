// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "widgets/model/scenepiece.h"

#include <optional>

namespace pixelplumb {

/// The new reference to a vertex after an edit. Primitives after inserted or removed ones are
/// renumbered, swapped ones exchange their numbers, and the vertices of a primitive that was
/// completed, or opened again, go with it. None where the vertex was removed. `triangleCount`: of
/// the scene before the edit.
std::optional<VertexRef> renamed(const VertexRef &ref, std::size_t triangleCount,
                                 const ScenePiece &before, const ScenePiece &after);

/// Whether a primitive is painted in one colour, that of its first vertex. A document gives it to
/// all of its vertices, so that their handles have the visible colour.
constexpr bool hasOneColour(PrimitiveKind kind)
{
    switch (kind) {
    case PrimitiveKind::Triangle:
    case PrimitiveKind::Point:
    case PrimitiveKind::Line:
        return false;
    case PrimitiveKind::Circle:
    case PrimitiveKind::Ellipse:
    case PrimitiveKind::Bezier:
    case PrimitiveKind::Polygon:
    case PrimitiveKind::Text:
        break;
    }
    return true;
}

} // namespace pixelplumb
