// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "core/space/facestages.h"

namespace pixelplumb {

/// The scene's appearance as kernels get it: its viewer is the camera, where there is one.
Appearance appearanceOf(const Scene &scene);

/// The triangles that the scene's solids become, in sample coordinates; in primitivesOnSamples()
/// they follow the scene's own. Without a camera they are seen through the default one.
ProjectedSolids projectedSolids(const Scene &scene);
/// None where the listener ended it.
std::optional<ProjectedSolids> projectedSolids(const Scene &scene,
                                               const ProgressListener &listener);

/// The way of the face of one of these triangles.
FaceStages stagesOf(const Scene &scene, const TriangleSource &source, int wExponent);
FaceStages stagesOf(const Scene &scene, const ProjectedSolids &projected, std::size_t triangle);

/// The corners of the polygon that clipping at the near plane makes of a face, on the lattice, in
/// sample coordinates; those that no coordinates reach are missing.
std::vector<LatticePoint> clippedPolygon(const Scene &scene, const TriangleSource &source);

} // namespace pixelplumb
