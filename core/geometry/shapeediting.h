// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <optional>
#include <span>

namespace pixelplumb {

/// How many vertices a person places for a primitive; none if vertices are added until it is
/// closed.
std::optional<std::size_t> placedVertexCount(PrimitiveKind kind);

/// The shape that placed vertices make: their colours stay, and a circle's corner moves onto its
/// square. `kind` is not Triangle; there are as many vertices as it needs. It gets the first of
/// `fills`, which its method draws (Method::fills).
Shape shapeFrom(PrimitiveKind kind, std::span<const Vertex> vertices,
                std::span<const ShapeFill> fills);

/// Moves one vertex of a shape. The centre of a circle or ellipse moves the whole shape; its corner
/// cannot shrink it to nothing, and a circle stays round. Pieces of a Bézier path that meet in the
/// vertex stay joined.
void moveVertex(Shape &shape, std::size_t vertex, const LatticePoint &position);

} // namespace pixelplumb
