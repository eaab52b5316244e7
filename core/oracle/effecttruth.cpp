// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effecttruth.h"

#include <algorithm>

namespace pixelplumb::oracle {

namespace {

bool haveOneColour(const Triangle &triangle)
{
    const auto &v = triangle.vertices;
    return v[0].colour == v[1].colour && v[1].colour == v[2].colour;
}

/// Beside depth and antialiasing, which are the picture's.
bool hasEffect(const Primitives &primitives, std::size_t triangle, const EffectTruth &what)
{
    const std::array<VertexAttributes, 3> &vertices = attributesOf(primitives, triangle);
    const Material *material = materialOf(primitives, triangle);
    const bool isOpaque = std::ranges::all_of(
        vertices, [](const VertexAttributes &vertex) { return vertex.alpha == 255; });
    const bool isLevel = std::ranges::all_of(
        vertices, [&](const VertexAttributes &vertex) { return vertex.w == vertices[0].w; });
    return (what.texture && material && material->texture) || isLit(primitives, triangle, what)
        || (what.blending && !isOpaque)
        || (what.perspective && !isLevel && !haveOneColour(primitives.triangles[triangle]));
}

} // namespace

EffectTruth truthOf(const Appearance &appearance)
{
    const auto isOn = [&](Effect effect) { return appearance.forced[effect] != Forcing::Off; };
    EffectTruth what;
    what.smooth = isOn(Effect::SmoothColour);
    what.perspective = isOn(Effect::Perspective);
    what.texture = isOn(Effect::Texture);
    what.light = isOn(Effect::Light);
    what.blending = isOn(Effect::Blending);
    what.depth = isOn(Effect::Depth)
        && (appearance.depth != DepthUse::Off || appearance.forced[Effect::Depth] == Forcing::On);
    if (isOn(Effect::Antialiasing))
        what.antialiasing = appearance.antialiasing;
    return what;
}

bool isPlain(const Primitives &primitives, const EffectTruth &what)
{
    if (what.depth || what.antialiasing != Antialiasing::None)
        return false;
    for (std::size_t triangle = 0; triangle < primitives.triangles.size(); ++triangle) {
        if (hasEffect(primitives, triangle, what))
            return false;
    }
    return true;
}

bool isLit(const Primitives &primitives, std::size_t triangle, const EffectTruth &what)
{
    const Appearance &appearance = primitives.appearance;
    const bool hasNormal
        = std::ranges::any_of(attributesOf(primitives, triangle), [](const VertexAttributes &of) {
              return std::ranges::any_of(of.normal, [](Attribute n) { return n != 0; });
          });
    return what.light && appearance.shading == Shading::Phong && !appearance.lights.empty()
        && hasNormal;
}

const Material *materialOf(const Primitives &primitives, std::size_t triangle)
{
    const TriangleAttributes *attributes = primitives.attributesOf(triangle);
    const std::vector<Material> &materials = primitives.appearance.materials;
    if (!attributes || attributes->material < 0
        || std::size_t(attributes->material) >= materials.size())
        return nullptr;
    return &materials[std::size_t(attributes->material)];
}

const std::array<VertexAttributes, 3> &attributesOf(const Primitives &primitives,
                                                    std::size_t triangle)
{
    static constexpr std::array<VertexAttributes, 3> none = {};
    const TriangleAttributes *attributes = primitives.attributesOf(triangle);
    return attributes ? attributes->vertices : none;
}

} // namespace pixelplumb::oracle
