// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/sceneprojection.h"

namespace pixelplumb {

namespace {

Camera cameraOf(const Scene &scene) { return scene.camera.value_or(Camera()); }

} // namespace

Appearance appearanceOf(const Scene &scene)
{
    if (!scene.camera && scene.solids.empty())
        return scene.appearance;
    return viewedBy(cameraOf(scene), scene.appearance);
}

ProjectedSolids projectedSolids(const Scene &scene) { return projectedSolids(scene, {}).value(); }

std::optional<ProjectedSolids> projectedSolids(const Scene &scene, const ProgressListener &listener)
{
    const Camera camera = cameraOf(scene);
    const Appearance appearance = appearanceOf(scene);
    return projectSolids({camera, scene.solids, appearance, scene.frame}, listener);
}

FaceStages stagesOf(const Scene &scene, const ProjectedSolids &projected, std::size_t triangle)
{
    const Camera camera = cameraOf(scene);
    const Appearance appearance = appearanceOf(scene);
    return stagesOf({camera, scene.solids, appearance, scene.frame}, projected.sources[triangle],
                    projected.wExponent);
}

} // namespace pixelplumb
