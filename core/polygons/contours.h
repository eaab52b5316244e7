// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <span>

namespace pixelplumb {

/// An edge of a contour, directed as the contour runs.
struct ContourEdge {
    LatticePoint from;
    LatticePoint to;

    friend bool operator==(const ContourEdge &, const ContourEdge &) = default;
};

/// A polygon as its edges, contour after contour, each closed by an edge back to its first vertex.
/// There are no other conditions: contours may be concave, cross themselves and each other, nest
/// and touch.
struct Contours {
    std::vector<ContourEdge> edges;
    std::size_t count = 0; ///< of contours
    std::size_t curveCount = 0; ///< Bézier pieces, where the edges are their chords
    ShapeFill fill = ShapeFill::EvenOdd;
    Colour colour; ///< of every sample: the colour of the polygon's first vertex
};

Contours contoursOf(const Shape &polygon);

/// The edges' bounding box, lattice units; empty, with first > last, without edges.
struct ContourBox {
    LatticePoint first = {1, 1};
    LatticePoint last = {0, 0};

    /// True where the box contains no area.
    bool isFlat() const { return first.x >= last.x || first.y >= last.y; }
};

ContourBox boxAround(std::span<const ContourEdge> edges);

/// The integer width that holds exact products of the edges' coordinates.
IntegerWidth integerWidthFor(std::span<const ContourEdge> edges);

} // namespace pixelplumb
