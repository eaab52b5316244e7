// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"
#include "core/geometry/lattice.h"

#include <array>
#include <span>
#include <utility>

namespace pixelplumb {

struct Vertex {
    LatticePoint position;
    Colour colour;

    friend constexpr bool operator==(const Vertex &, const Vertex &) = default;
};

/// Three vertices in the order in which the user gave them; kernels never reorder them.
struct Triangle {
    std::array<Vertex, 3> vertices;

    friend constexpr bool operator==(const Triangle &, const Triangle &) = default;
};

/// Twice the signed area in square lattice units: positive when the vertices turn
/// counter-clockwise in a y-upward frame. |value| <= 2^79.
constexpr Int128 doubledArea(const LatticePoint &a, const LatticePoint &b, const LatticePoint &c)
{
    return Int128(b.x - a.x) * (c.y - a.y) - Int128(c.x - a.x) * (b.y - a.y);
}

constexpr Int128 doubledArea(const Triangle &triangle)
{
    return doubledArea(triangle.vertices[0].position, triangle.vertices[1].position,
                       triangle.vertices[2].position);
}

/// The vertices' indices sorted by x, then y, then index: P0, P1, P2 of the assignment.
/// Force-inlined: a call would read them back from memory in words of another size than they were
/// stored in, and stall until every earlier pixel is stored.
[[gnu::always_inline]] inline constexpr std::array<int, 3> sortedByColumn(const Triangle &triangle)
{
    std::array<int, 3> order = {0, 1, 2};
    const auto before = [&](int a, int b) {
        return triangle.vertices[std::size_t(a)].position
            < triangle.vertices[std::size_t(b)].position;
    };
    // Three compare-and-exchange steps that keep equal vertices in their order (a stable sort).
    if (before(order[1], order[0]))
        std::swap(order[0], order[1]);
    if (before(order[2], order[1]))
        std::swap(order[1], order[2]);
    if (before(order[1], order[0]))
        std::swap(order[0], order[1]);
    return order;
}

/// The integer width that the exact kernel needs; chosen per primitive.
enum class IntegerWidth { Bits64, Bits128 };

constexpr IntegerWidth integerWidthFor(std::span<const Vertex> vertices)
{
    for (const Vertex &vertex : vertices) {
        if (!isNarrow(vertex.position))
            return IntegerWidth::Bits128;
    }
    return IntegerWidth::Bits64;
}

constexpr IntegerWidth integerWidthFor(const Triangle &triangle)
{
    return integerWidthFor(triangle.vertices);
}

} // namespace pixelplumb
