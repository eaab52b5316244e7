// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/planbyhand.h"

#include <algorithm>

namespace pixelplumb {

namespace {

EffectSet effectsOf(const Primitives &primitives, std::size_t index)
{
    const Appearance &appearance = primitives.appearance;
    EffectSet effects;
    const auto &corners = primitives.triangles[index].vertices;
    effects.smooth
        = corners[0].colour != corners[1].colour || corners[1].colour != corners[2].colour;
    if (appearance.depth != DepthUse::Off)
        effects.depth
            = appearance.depthFormat == DepthFormat::Exact ? DepthTest::Number : DepthTest::Levels;
    const TriangleAttributes *attributes = primitives.attributesOf(index);
    if (!attributes)
        return effects;
    for (const VertexAttributes &vertex : attributes->vertices) {
        effects.perspective = effects.perspective || vertex.w != attributes->vertices[0].w;
        effects.blending = effects.blending || vertex.alpha != 255;
        effects.light = effects.light || vertex.normal != std::array<Attribute, 3>{0, 0, 0};
    }
    effects.light = effects.light && !appearance.lights.empty();
    effects.texture = attributes->material != noMaterial
        && appearance.materials[std::size_t(attributes->material)].texture;
    return effects;
}

} // namespace

EffectPlan planByHand(const Primitives &primitives)
{
    EffectPlan plan;
    plan.antialiasing = primitives.appearance.antialiasing;
    for (std::size_t index = 0; index < primitives.triangles.size(); ++index) {
        const EffectSet effects = effectsOf(primitives, index);
        if (plan.batches.empty() || plan.batches.back().effects != effects)
            plan.batches.push_back({index, 0, effects});
        ++plan.batches.back().count;
    }
    return plan;
}

} // namespace pixelplumb
