// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"

#include <array>
#include <cstddef>

namespace pixelplumb {

/// What a vertex may carry beside its colour (Scan Conversion slides, "Interpolation During Scan
/// Conversion"), in units of 1/256 and within ±2^30, as coordinates are.
struct VertexAttributes {
    Lattice z = 0; ///< depth
    std::array<Lattice, 2> texture = {}; ///< u, v
    std::array<Lattice, 3> normal = {}; ///< N_x, N_y, N_z; of any length

    friend constexpr bool operator==(const VertexAttributes &, const VertexAttributes &) = default;
};

/// The attributes of one triangle of a scene. Lists of them are sparse, in ascending order: few
/// triangles have any, and those without have zeros.
struct TriangleAttributes {
    std::size_t triangle = 0; ///< its index
    std::array<VertexAttributes, 3> vertices;

    friend constexpr bool operator==(const TriangleAttributes &, const TriangleAttributes &)
        = default;
};

} // namespace pixelplumb
