// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/motion.h"

#include "core/number/integer.h"
#include "core/scene/scene.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// way·frame/last rounded to nearest, ties to the greater; |way| ≤ 2^39, frame < 2^10.
Lattice partOf(Lattice way, int frame, int last)
{
    return floorDivide(2 * way * frame + last, Lattice(2 * last));
}

} // namespace

Scene sceneAtFrame(const Scene &scene, int frame)
{
    Scene moved = scene;
    if (!scene.motion)
        return moved;
    moved.motion.reset();
    const int last = scene.motion->frames - 1;
    const LatticePoint by
        = {partOf(scene.motion->by.x, frame, last), partOf(scene.motion->by.y, frame, last)};
    const auto move = [&by](LatticePoint &point) {
        point = {std::clamp(point.x + by.x, -largestCoordinate, largestCoordinate),
                 std::clamp(point.y + by.y, -largestCoordinate, largestCoordinate)};
    };
    for (Triangle &triangle : moved.triangles) {
        for (Vertex &vertex : triangle.vertices)
            move(vertex.position);
    }
    for (Shape &shape : moved.shapes) {
        for (Vertex &vertex : shape.vertices)
            move(vertex.position);
    }
    return moved;
}

} // namespace pixelplumb
