// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene.h"

namespace pixelplumb {

Lattice sampleOffset(const FrameSpec &spec)
{
    return spec.pixelCentre == PixelCentre::Half ? unitsPerPixel / 2 : 0;
}

std::vector<Triangle> trianglesOnSamples(const Scene &scene)
{
    std::vector<Triangle> triangles = scene.triangles;
    const Lattice offset = sampleOffset(scene.frame);
    for (Triangle &triangle : triangles) {
        for (Vertex &vertex : triangle.vertices) {
            vertex.position.x -= offset;
            vertex.position.y -= offset;
        }
    }
    return triangles;
}

} // namespace pixelplumb
