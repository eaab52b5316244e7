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

FaceStages stagesOf(const Scene &scene, const TriangleSource &source, int wExponent)
{
    const Camera camera = cameraOf(scene);
    const Appearance appearance = appearanceOf(scene);
    return stagesOf(SpaceScene{camera, scene.solids, appearance, scene.frame}, source, wExponent);
}

std::vector<LatticePoint> clippedPolygon(const Scene &scene, const TriangleSource &source)
{
    const Camera camera = cameraOf(scene);
    const Appearance appearance = appearanceOf(scene);
    const SpaceScene space{camera, scene.solids, appearance, scene.frame};
    FaceProjector<double> projector(space, scene.solids[source.solid]);
    const ProjectedFace<double> &face = projector.project(source.face);
    std::vector<LatticePoint> corners;
    for (std::size_t i = 0; i < face.clipped.size(); ++i) {
        const SnappedCorner corner = snapped(face.clipped[i], face.places[i], face.devices[i].z, 0);
        if (corner.loss != ProjectionLoss::NotFinite
            && corner.loss != ProjectionLoss::OutsideCoordinates)
            corners.push_back(corner.vertex.position);
    }
    return corners;
}

FaceStages stagesOf(const Scene &scene, const ProjectedSolids &projected, std::size_t triangle)
{
    return stagesOf(scene, projected.sources[triangle], projected.wExponent);
}

} // namespace pixelplumb
