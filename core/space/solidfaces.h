// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

namespace pixelplumb {

/// The number of a solid's faces: convex, flat polygons, each a list of the solid's vertices,
/// counter-clockwise seen from outside, in drawing order. A cell of a sphere's segments is one
/// face, a triangle at the poles; a cell of a patch, which is not flat, is two triangles.
std::size_t faceCount(const Solid &solid);

/// Writes the indices of the face's vertices to a reusable buffer.
void takeFace(const Solid &solid, std::size_t face, std::vector<std::size_t> &vertices);

/// A sphere or patch has a grid of segments[0] + 1 by segments[1] + 1 vertices, row by row: a
/// sphere's first row is its upper pole, a patch's is v = 0. Other solids have a vertex for each
/// corner.
std::size_t vertexCount(const Solid &solid);

} // namespace pixelplumb
