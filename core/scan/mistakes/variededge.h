// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"
#include "core/scan/scanbugs.h"
#include "core/scan/variants.h"

#include <algorithm>

namespace pixelplumb {

/// Variants along an edge, where the order of spans makes a difference.
inline constexpr std::array variantsAlongEdges
    = {Variant::NoEdgePreStep, Variant::DivisorMinusOne, Variant::DivisorPlusOne,
       Variant::UnsortedColours};

/// Of a set of variants, those that change an edge.
constexpr EdgeChanges edgeChangesOf(VariantSet variants)
{
    EdgeChanges changes;
    for (const auto &[variant, change] :
         {std::pair(Variant::NoEdgePreStep, edgechange::noPreStep),
          std::pair(Variant::DivisorMinusOne, edgechange::divisorMinusOne),
          std::pair(Variant::DivisorPlusOne, edgechange::divisorPlusOne)}) {
        if (variants.contains(variant))
            changes = changes | change;
    }
    return changes;
}

struct VariedEdge {
    Vertex a, b;
};

/// The edge from a to b with its changes. Divided by Δ ∓ 1, it has the slope of one whose other end
/// is a pixel nearer or farther; without a pre-step it is one that begins at its first column. An
/// edge of at most a pixel, where Δ − 1 leaves nothing, stays at its first vertex; one along the
/// column has no slope.
constexpr VariedEdge variedEdge(const Vertex &a, const Vertex &b, EdgeChanges changes)
{
    VariedEdge edge{a, b};
    if (a.position.x == b.position.x)
        return edge;
    if (changes.contains(edgechange::divisorMinusOne))
        edge.b.position.x = std::max(b.position.x - unitsPerPixel, a.position.x);
    if (changes.contains(edgechange::divisorPlusOne))
        edge.b.position.x += unitsPerPixel;
    if (changes.contains(edgechange::noPreStep)) {
        const Lattice late = ceilPixel(a.position.x) * unitsPerPixel - a.position.x;
        edge.a.position.x += late;
        edge.b.position.x += late;
    }
    return edge;
}

/// The triangle with sorted vertices but colours in the order given: the i-th vertex in sorted
/// order gets the i-th colour.
constexpr Triangle withUnsortedColours(const Triangle &triangle, const std::array<int, 3> &order)
{
    Triangle result = triangle;
    for (std::size_t i = 0; i < 3; ++i)
        result.vertices[std::size_t(order[i])].colour = triangle.vertices[i].colour;
    return result;
}

} // namespace pixelplumb
