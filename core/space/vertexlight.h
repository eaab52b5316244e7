// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/appearance.h"
#include "core/geometry/triangle.h"
#include "core/space/materialcolour.h"
#include "core/space/spacevector.h"

#include <vector>

/// Flat and Gouraud shading before scan conversion: the material's diffuse colour, and the light at
/// a face's centre or vertices. Phong shading, at the samples, is left to the kernels.
namespace pixelplumb {

/// A point that light falls on, in the scene's space.
template <class Number>
struct LitPoint {
    SpaceVector<Number> place;
    SpaceVector<Number> normal; ///< of any length; 0: ambient light only
};

/// A colour, already multiplied by the material's, and the point where light falls on it.
template <class Number>
struct LitColour {
    Colour colour;
    LitPoint<Number> point;
};

/// The points where light falls on a plain triangle whose corners have their positions: each
/// corner, or in flat shading their mean.
template <class Number>
std::vector<LitColour<Number>> litColoursOf(const Triangle &triangle,
                                            const TriangleAttributes &attributes, Shading shading);

/// The unit vectors of a light at a point; 0 where undefined.
template <class Number>
struct LightVectors {
    SpaceVector<Number> normal; ///< n
    SpaceVector<Number> toLight; ///< L
    SpaceVector<Number> toViewer; ///< V
    SpaceVector<Number> halfway; ///< H, from L + V [Blinn 1977]
};
template <class Number>
LightVectors<Number> lightVectors(const Appearance &appearance, const Light &light,
                                  const LitPoint<Number> &point);

/// The contribution of one light at a point.
template <class Number>
struct LightTerm {
    Number diffuse = Number(0); ///< max(0, N·L)
    Number specular = Number(0); ///< max(0, N·H)^shininess where N·L > 0
};

template <class Number>
LightTerm<Number> lightTerm(const Appearance &appearance, const Light &light, int shininess,
                            const LitPoint<Number> &point);

/// c·(ambient + Σ light·diffuse)/255 + Σ light·specular·s/255 for each channel, before rounding and
/// clamping.
template <class Number>
std::array<Number, 3> litLevels(const Appearance &appearance, const Material &material,
                                const Colour &colour, const LitPoint<Number> &point);

/// ⌊level + ½⌋, clamped to 0 … 255.
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

/// Multiplies the vertex colours by the material's diffuse colour.
void tint(Triangle &triangle, const Material &material);

/// Whether set-up lights what has normals: shading is flat or Gouraud, there are lights, and light
/// is not switched off.
bool lightsVertices(const Appearance &appearance);

/// Lights plain triangles, in the scene's coordinates: multiplies the vertex colours by their
/// material's diffuse colour and, where there are lights, gives the vertices of triangles with
/// normals their position (x, y, z) in px, and lights them if lightsVertices(): flat by the mean of
/// the corners, or Gouraud.
void lightPlainTriangles(std::vector<Triangle> &triangles,
                         std::vector<TriangleAttributes> &attributes, const Appearance &appearance);

} // namespace pixelplumb
