// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/tracerecords.h"

#include <QString>

namespace pixelplumb {

/// The names of a triangle's vertices and edges, the same on the canvas, in formulas and in
/// reasons. A method that sorts the vertices has P₀, P₁ and P₂ in its own order and the edges L₀₁,
/// L₁₂ and L₀₂; any other has them in the caller's order, and its edges go from vertex to vertex:
/// P₂P₀. Vertices are given by their indices in the caller's triangle.
QString vertexName(const SetUpRecord &setUp, int vertex);
QString edgeName(const SetUpRecord &setUp, int from, int to);

} // namespace pixelplumb
