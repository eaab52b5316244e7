// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// A number that a vertex carries besides its position in the frame and its colour: an integer in
/// units of 2^-24, |value| <= 2^20. Finer than the lattice of coordinates: u = 1/3 moves by less
/// than 2^-25. The exact kernels' products are bounded for this format (resources/numerics.md).
using Attribute = std::int64_t;

inline constexpr int attributeFractionBits = 24;
inline constexpr Attribute attributeOne = Attribute(1) << attributeFractionBits;
inline constexpr Attribute largestAttributeValue = Attribute(1) << 20;
inline constexpr Attribute largestAttribute = largestAttributeValue * attributeOne;

/// What a vertex may carry besides its colour (Scan Conversion slides, "Interpolation During Scan
/// Conversion"; Triangle Rasterization slides, "Projection of triangles").
struct VertexAttributes {
    Attribute z = 0; ///< depth; smaller is nearer; 0 … 1 between a camera's planes
    /// The divisor of the camera's projection, > 0; only its ratio to the other vertices' w
    /// matters. Where w differs, attributes are interpolated as a/w and 1/w.
    Attribute w = attributeOne;
    std::array<Attribute, 2> texture = {}; ///< u, v
    std::array<Attribute, 3> normal = {}; ///< N_x, N_y, N_z; of any length
    /// The point in the scene's space that light falls on; for a plain triangle (x, y, z), px.
    std::array<Attribute, 3> place = {};
    std::uint8_t alpha = 255; ///< 0 transparent … 255 opaque

    friend constexpr bool operator==(const VertexAttributes &, const VertexAttributes &) = default;
};

/// No material: the vertices' colours only.
inline constexpr int noMaterial = -1;

/// The attributes of one triangle of a scene. Lists of them are sparse, in ascending order: few
/// triangles have any, and the others have zeros, w = 1 and alpha = 255.
struct TriangleAttributes {
    std::size_t triangle = 0; ///< its index
    std::array<VertexAttributes, 3> vertices;
    int material = noMaterial; ///< index into the scene's materials

    friend constexpr bool operator==(const TriangleAttributes &, const TriangleAttributes &)
        = default;
};

} // namespace pixelplumb
