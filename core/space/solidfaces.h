// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/solid.h"

namespace pixelplumb {

/// A solid is drawn as faces, convex polygons in one plane, each a list of the solid's vertices,
/// counter-clockwise seen from outside, in drawing order. A cell of a sphere's segments is one
/// face, at the poles a triangle; a cell of a patch, which is not flat, is two triangles.
std::size_t faceCount(const Solid &solid);

/// The indices of the face's vertices; a buffer that is used again and again.
void takeFace(const Solid &solid, std::size_t face, std::vector<std::size_t> &vertices);

/// Of a sphere and a patch: a grid of segments[0] + 1 by segments[1] + 1, row by row: a sphere's
/// first row is its upper pole, a patch's v = 0. Of the others: as many as they have corners.
std::size_t vertexCount(const Solid &solid);

} // namespace pixelplumb
