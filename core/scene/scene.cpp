// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/scene.h"

#include "core/scene/sceneprojection.h"
#include "core/space/vertexlight.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Appends after the triangles already there.
void append(ProjectedSolids projected, Primitives &primitives)
{
    const std::size_t first = primitives.triangles.size();
    for (TriangleAttributes &attributes : projected.attributes)
        attributes.triangle += first;
    for (const std::size_t triangle : projected.cutAtNear)
        primitives.cutAtNear.push_back(first + triangle);
    const auto appendTo = [](auto &all, auto &more) {
        if (all.empty())
            all = std::move(more);
        else
            all.insert(all.end(), more.begin(), more.end());
    };
    appendTo(primitives.triangles, projected.triangles);
    appendTo(primitives.attributes, projected.attributes);
    primitives.sources = std::move(projected.sources);
    primitives.wExponent = projected.wExponent;
}

/// Moves plain primitives to sample coordinates.
void shiftToSamples(Lattice offset, Primitives &primitives)
{
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
}

} // namespace

bool Scene::hasSolids() const { return !std::ranges::all_of(solids, &Solid::isHidden); }

std::size_t Scene::hiddenCount() const
{
    return hidden.size() + std::size_t(std::ranges::count_if(solids, &Solid::isHidden));
}

bool mayCallForEffects(const Scene &scene)
{
    return !scene.attributes.empty() || scene.hasSolids() || scene.appearance.asksForEffects();
}

Primitives primitivesOnSamples(const Scene &scene)
{
    return primitivesOnSamples(scene, {}).value();
}

std::optional<Primitives> primitivesOnSamples(const Scene &scene, const ProgressListener &listener)
{
    Primitives primitives{scene.triangles, scene.shapes, scene.attributes, appearanceOf(scene)};
    if (scene.frame.origin == FrameOrigin::TopLeft) {
        for (Shape &shape : primitives.shapes)
            shape.textHeight = -shape.textHeight;
    }
    lightPlainTriangles(primitives.triangles, primitives.attributes, primitives.appearance);
    if (const Lattice offset = sampleOffset(scene.frame); offset != 0)
        shiftToSamples(offset, primitives);
    if (scene.solids.empty())
        return primitives;
    auto projected = projectedSolids(scene, listener);
    if (!projected)
        return std::nullopt;
    append(std::move(*projected), primitives);
    return primitives;
}

BoundaryRule boundaryRuleOf(const Scene &scene)
{
    return {scene.settings.fillRule, scene.frame.origin, offScreenSample(scene.frame)};
}

} // namespace pixelplumb
