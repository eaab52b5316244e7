// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/geometry/triangle.h"
#include "core/space/materialcolour.h"
#include "core/space/spacevector.h"

#include <vector>

/// What flat and Gouraud shading compute before scan conversion: the material's diffuse colour, and
/// the light at a face's centre or at its vertices. At samples, shading by Phong, light is the
/// kernels'.
namespace pixelplumb {

/// A point that light falls on, in the scene's space.
template <class Number>
struct LitPoint {
    SpaceVector<Number> place;
    SpaceVector<Number> normal; ///< of any length; 0: no light but the ambient one
};

/// A colour, the material's multiplied in, and where light falls on it.
template <class Number>
struct LitColour {
    Colour colour;
    LitPoint<Number> point;
};

/// Where light falls on a plain triangle whose corners have their places: on each of them, or in
/// flat shading on the mean of all.
template <class Number>
std::vector<LitColour<Number>> litColoursOf(const Triangle &triangle,
                                            const TriangleAttributes &attributes, Shading shading);

/// The vectors of length 1 by which a light counts at a point; 0 where there is none.
template <class Number>
struct LightVectors {
    SpaceVector<Number> normal; ///< n
    SpaceVector<Number> toLight; ///< L
    SpaceVector<Number> toViewer; ///< V
    SpaceVector<Number> halfway; ///< H, of L + V [Blinn 1977]
};
template <class Number>
LightVectors<Number> lightVectors(const Appearance &appearance, const Light &light,
                                  const LitPoint<Number> &point);

/// What one light adds at a point.
template <class Number>
struct LightTerm {
    Number diffuse = Number(0); ///< max(0, N·L)
    Number specular = Number(0); ///< max(0, N·H)^shininess where N·L > 0
};

template <class Number>
LightTerm<Number> lightTerm(const Appearance &appearance, const Light &light, int shininess,
                            const LitPoint<Number> &point);

/// c·(ambient + Σ light·diffuse)/255 + Σ light·specular·s/255 of each channel, before it is rounded
/// and clamped.
template <class Number>
std::array<Number, 3> litLevels(const Appearance &appearance, const Material &material,
                                const Colour &colour, const LitPoint<Number> &point);

/// ⌊level + ½⌋ within 0 … 255.
template <class Number>
std::uint8_t levelByte(const Number &level)
{
    using std::floor;
    if (!(level > 0))
        return 0;
    const Number whole = floor(level);
    const int rounded = level >= 255 ? 255 : int(whole) + (level - whole >= Number(1) / 2 ? 1 : 0);
    return std::uint8_t(rounded > 255 ? 255 : rounded);
}

/// Multiplies the material's diffuse colour into the vertices.
void tint(Triangle &triangle, const Material &material);

/// Whether light is computed in set-up, of what has normals: flat and Gouraud shading, where a
/// light is on and not switched off.
bool lightsVertices(const Appearance &appearance);

/// Of plain triangles, in the scene's coordinates: multiplies their material's diffuse colour into
/// the vertices, gives those of triangles with normals their place (x, y, z), px, where there are
/// lights, and lights them where lightsVertices(): flat, by the mean of the corners, or Gouraud's.
void lightPlainTriangles(std::vector<Triangle> &triangles,
                         std::vector<TriangleAttributes> &attributes, const Appearance &appearance);

} // namespace pixelplumb
