// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/scan/redrawing.h"

/// Mistakes of programs that test the samples of a bounding box, as changes of the right spans,
/// which are its rows.
namespace pixelplumb {

void fillBox(TriangleRuns &triangle); ///< draws all of it

// Samples of the box that are left out.
void omitFirstRowOfBox(TriangleRuns &triangle); ///< ⌈y_min⌉
void omitLastRowOfBox(TriangleRuns &triangle); ///< ⌊y_max⌋
void omitFirstColumnOfBox(TriangleRuns &triangle);
void omitLastColumnOfBox(TriangleRuns &triangle);
void omitGreatestOfBox(TriangleRuns &triangle); ///< x_max and y_max, where they are whole
/// Leaves out samples outside the box of the edge from that vertex to the next.
void omitBesideBoxOfEdge(TriangleRuns &triangle, std::size_t vertex);

/// Leaves out samples exactly on the edge from that vertex to the next.
void omitOnEdge(TriangleRuns &triangle, std::size_t vertex);

} // namespace pixelplumb
