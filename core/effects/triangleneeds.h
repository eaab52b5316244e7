// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"
#include "core/effects/framereach.h"

namespace pixelplumb {

/// What a triangle needs by itself, whatever stands around it.
struct TriangleNeeds {
    EffectSet effects; ///< depth is a question of the others: none
    bool vertexLight = false; ///< in set-up, of flat and Gouraud shading
    int lowestAlpha = 255; ///< that it carries

    // What perspective is asked by.
    bool wDiffers = false; ///< between the vertices
    // What differs between the vertices, counts at a sample and is not switched off.
    bool carriesColour = false;
    bool carriesAlpha = false;
    bool carriesTexture = false; ///< u, v of a triangle that has a texture
    bool carriesLight = false; ///< normals or places that light looks at

    bool carriesAnything() const
    {
        return carriesColour || carriesAlpha || carriesTexture || carriesLight;
    }
};

/// The material's texture; null where there is none, or none with a texel.
const Texture *textureOf(const TriangleAttributes &attributes, const Appearance &appearance);
bool hasNormals(const TriangleAttributes &attributes);

/// Whether the three vertices are one place.
bool isPoint(const Triangle &triangle);

/// What a triangle is painted in where colours are not interpolated: the colour of its first
/// vertex, of a segment that of its first end.
Colour oneColourOf(const Triangle &triangle);

/// `attributes` may be null.
TriangleNeeds needsOf(const Triangle &triangle, const TriangleAttributes *attributes,
                      const Appearance &appearance);

/// Whether its plane has a horizon: w differs, and something that is divided by it and is not
/// forced off does too. What is the same everywhere is so beyond it.
bool hasHorizon(const Triangle &triangle, const TriangleAttributes *attributes,
                const Appearance &appearance);

/// The w of the vertices, positive, as kernels take them, where areas are drawn up to the horizon
/// of the triangle's plane alone; else zeros.
std::array<Attribute, 3> horizonOf(const Triangle &triangle, const TriangleAttributes *attributes,
                                   const Appearance &appearance, const SampledFrame &where);

} // namespace pixelplumb
