// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// General scan conversion by parity, with an edge table and active edges.
Method polygonParityMethod();
/// Any polygon, broken into triangles with vertices where its edges cross.
Method polygonTessellationMethod();
/// The edges of a polygon as lines.
Method polygonOutlineMethod();
/// A convex polygon as a fan of triangles.
Method polygonFanMethod();
/// Any polygon that does not cross itself, broken into triangles by a constrained Delaunay
/// triangulation.
Method polygonDelaunayMethod();

/// Adds to a kernel's method what all methods of polygons share: one rule for samples on the
/// boundary, and why.
Method polygonMethod(Method method);
/// The pseudocode of scan conversion by parity, wherever the edges come from.
Pseudocode parityPseudocode();
/// The loop over the rows that the edges cross, with the crossings x_k in each.
Pseudocode crossingLines(int depth);

} // namespace pixelplumb
