// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/redrawing.h"

/// What programs do wrong that test the samples of a bounding box, as changes of the right spans,
/// which are its rows.
namespace pixelplumb {

void fillBox(TriangleRuns &triangle); ///< all of it is drawn

// Samples of the box that are left out.
void omitFirstRowOfBox(TriangleRuns &triangle); ///< ⌈y_min⌉
void omitLastRowOfBox(TriangleRuns &triangle); ///< ⌊y_max⌋
void omitFirstColumnOfBox(TriangleRuns &triangle);
void omitLastColumnOfBox(TriangleRuns &triangle);
void omitGreatestOfBox(TriangleRuns &triangle); ///< x_max and y_max, where they are whole
/// Those beside the box of the edge from that vertex to the next.
void omitBesideBoxOfEdge(TriangleRuns &triangle, std::size_t vertex);

/// The samples exactly on the edge from that vertex to the next.
void omitOnEdge(TriangleRuns &triangle, std::size_t vertex);

} // namespace pixelplumb
