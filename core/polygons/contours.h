// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <span>

namespace pixelplumb {

/// An edge of a contour, in the direction in which the contour runs.
struct ContourEdge {
    LatticePoint from;
    LatticePoint to;

    friend bool operator==(const ContourEdge &, const ContourEdge &) = default;
};

/// A polygon as its edges, contour after contour, each contour closed by an edge back to its first
/// vertex. Nothing else is asked of it: contours may be concave, cross themselves and each other,
/// lie within one another, and touch.
struct Contours {
    std::vector<ContourEdge> edges;
    std::size_t count = 0; ///< of the contours
    std::size_t curveCount = 0; ///< Bézier pieces, where the edges are their chords
    ShapeFill fill = ShapeFill::EvenOdd;
    Colour colour; ///< of every sample: that of the polygon's first vertex
};

Contours contoursOf(const Shape &polygon);

/// The smallest box around the edges, lattice units; empty, with first > last, without edges.
struct ContourBox {
    LatticePoint first = {1, 1};
    LatticePoint last = {0, 0};

    /// True where no area lies within the box.
    bool isFlat() const { return first.x >= last.x || first.y >= last.y; }
};

ContourBox boxAround(std::span<const ContourEdge> edges);

/// Which integers hold the exact products of the edges' coordinates.
IntegerWidth integerWidthFor(std::span<const ContourEdge> edges);

} // namespace pixelplumb
