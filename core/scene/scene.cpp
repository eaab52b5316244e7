// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene.h"

namespace pixelplumb {

Primitives primitivesOnSamples(const Scene &scene)
{
    Primitives primitives{scene.triangles, scene.shapes, scene.attributes, scene.appearance};
    if (scene.frame.origin == FrameOrigin::TopLeft) {
        for (Shape &shape : primitives.shapes)
            shape.textHeight = -shape.textHeight;
    }
    const Lattice offset = sampleOffset(scene.frame);
    if (offset == 0)
        return primitives;
    const auto shift = [offset](auto &vertices) {
        for (Vertex &vertex : vertices) {
            vertex.position.x -= offset;
            vertex.position.y -= offset;
        }
    };
    for (Triangle &triangle : primitives.triangles)
        shift(triangle.vertices);
    for (Shape &shape : primitives.shapes)
        shift(shape.vertices);
    return primitives;
}

BoundaryRule boundaryRuleOf(const Scene &scene)
{
    return {scene.settings.fillRule, scene.frame.origin, offScreenSample(scene.frame)};
}

} // namespace pixelplumb
