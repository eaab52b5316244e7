// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/space/exactreal.h"
#include "core/space/facestages.h"
#include "core/space/stagevectors.h"

/// What the points of a face's light are described by, as used and without rounding.
namespace pixelplumb {

/// What light falls on: a face or a plain triangle.
struct LitPart {
    const Appearance &appearance;
    const Material &material;
    std::size_t vertices = 0;
    // How the centre of flat shading comes about, its place and its normal.
    Component centrePlace;
    Component centreNormal;
};

/// How light falls on a face's vertices or its centre: what all points share, the viewer, the
/// lights and what the material does with them; then at each point n, L, V and H of length 1, the
/// terms of each light, the levels and their bytes. `used` and `exact` are of the same points; in
/// Gouraud shading their places and normals are told before.
ProjectionStage lightStageOf(const LitPart &part, const std::vector<LitColour<double>> &used,
                             const std::vector<LitColour<ExactReal>> &exact);

/// A vertex's own colour c, and base, which has the material's multiplied in.
void writeTint(StagePoint &point, const Colour &given, const Colour &diffuse);

/// The light that a plain triangle with normals has before scan conversion, computed again by the
/// code that lights it: its corners, and how light falls on them, or in flat shading on their mean.
/// `given`: as the scene has it.
std::vector<ProjectionStage> lightStagesOf(const Triangle &given,
                                           const TriangleAttributes &attributes,
                                           const Appearance &appearance);

} // namespace pixelplumb
