// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"
#include "core/space/stagevectors.h"

/// Writes the points of a face's light stage, with and without rounding.
namespace pixelplumb {

/// What light falls on: a face or a plain triangle.
struct LitPart {
    const Appearance &appearance;
    const Material &material;
    std::size_t vertices = 0;
    // The formulas of the position and the normal of flat shading's centre.
    Component centrePlace;
    Component centreNormal;
};

/// The light stage of a face's vertices or centre. Shared by all points: the viewer, the lights and
/// how the material reflects them. At each point: n, L, V and H, normalized, the terms of each
/// light, the levels and their bytes. `used` and `exact` describe the same points; in Gouraud
/// shading their positions and normals are in the previous stage.
ProjectionStage lightStageOf(const LitPart &part, const std::vector<LitColour<double>> &used,
                             const std::vector<LitColour<ExactReal>> &exact);

/// A vertex's own colour c, and base, its product with the material's diffuse colour.
void writeTint(StagePoint &point, const Colour &given, const Colour &diffuse);

/// The stages of light on a plain triangle with normals before scan conversion, recomputed by the
/// code that lights it: its corners, and the light on them, or in flat shading on their mean.
/// `given`: the triangle as in the scene.
std::vector<ProjectionStage> lightStagesOf(const Triangle &given,
                                           const TriangleAttributes &attributes,
                                           const Appearance &appearance);

} // namespace pixelplumb
