// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <optional>
#include <span>

namespace pixelplumb {

/// How many vertices a person places for a primitive; none where it goes on until it is closed.
std::optional<std::size_t> placedVertexCount(PrimitiveKind kind);

/// The shape that placed vertices make: their colours stay, a circle's corner comes onto its
/// square. `kind` is no triangle; there are as many vertices as it takes. Of the fills that its
/// method draws (Method::fills) it gets the first.
Shape shapeFrom(PrimitiveKind kind, std::span<const Vertex> vertices,
                std::span<const ShapeFill> fills);

/// Moves one vertex of a shape. A circle or ellipse moves as a whole by its centre, and its corner
/// keeps it from shrinking to nothing; a circle stays round. Pieces of a Bézier path that meet in
/// the vertex go on meeting.
void moveVertex(Shape &shape, std::size_t vertex, const LatticePoint &position);

} // namespace pixelplumb
