// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"
#include "core/space/facestages.h"

namespace pixelplumb {

/// The scene's appearance for the kernels: its viewer is the camera, where there is one.
Appearance appearanceOf(const Scene &scene);

/// The scene's solids as triangles in sample coordinates; in primitivesOnSamples() they follow the
/// scene's own. Without a camera the default one is used.
ProjectedSolids projectedSolids(const Scene &scene);
/// Like projectedSolids(scene), but none where the listener ended it.
std::optional<ProjectedSolids> projectedSolids(const Scene &scene,
                                               const ProgressListener &listener);

/// The stages of the face that one of these triangles comes from.
FaceStages stagesOf(const Scene &scene, const TriangleSource &source, int wExponent);
FaceStages stagesOf(const Scene &scene, const ProjectedSolids &projected, std::size_t triangle);

/// The corners of the polygon that clipping at the near plane makes of a face, on the lattice, in
/// sample coordinates; corners beyond the range of coordinates are missing.
std::vector<LatticePoint> clippedPolygon(const Scene &scene, const TriangleSource &source);

} // namespace pixelplumb
