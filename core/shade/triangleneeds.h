// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/effectplan.h"

namespace pixelplumb {

/// What a triangle needs on its own, regardless of all others.
struct TriangleNeeds {
    EffectSet effects; ///< depth depends on the others: none
    bool vertexLight = false; ///< light in set-up, for flat and Gouraud shading
    int lowestAlpha = 255; ///< the lowest that it carries

    // These decide whether it needs perspective.
    bool wDiffers = false; ///< between the vertices
    // Set where a value differs between the vertices, matters at a sample and is not switched off.
    bool carriesColour = false;
    bool carriesAlpha = false;
    bool carriesTexture = false; ///< u, v of a triangle that has a texture
    bool carriesLight = false; ///< normals or places that light depends on

    bool carriesAnything() const
    {
        return carriesColour || carriesAlpha || carriesTexture || carriesLight;
    }
};

/// The material's texture; null where there is none, or none with texels.
const Texture *textureOf(const TriangleAttributes &attributes, const Appearance &appearance);
bool hasNormals(const TriangleAttributes &attributes);

/// Whether the three vertices coincide.
bool isPoint(const Triangle &triangle);

/// The triangle's colour where colours are not interpolated: its first vertex's; for a segment that
/// of its first end.
Colour oneColourOf(const Triangle &triangle);

/// `attributes` may be null.
TriangleNeeds needsOf(const Triangle &triangle, const TriangleAttributes *attributes,
                      const Appearance &appearance);

/// Whether its plane has a horizon: w differs, and so does something that is divided by it and not
/// forced off. What is constant stays the same beyond it.
bool hasHorizon(const Triangle &triangle, const TriangleAttributes *attributes,
                const Appearance &appearance);

} // namespace pixelplumb
