// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/effecttruth.h"

#include <algorithm>
#include <functional>

namespace pixelplumb::oracle {

namespace {

/// Whether the value differs between the three vertices.
template <class Vertices, class Value>
bool differ(const Vertices &vertices, const Value &value)
{
    return !std::ranges::all_of(vertices, [&](const auto &vertex) {
        return std::invoke(value, vertex) == std::invoke(value, vertices[0]);
    });
}

/// Whether light depends on the place: a light shines from a place, or its highlight is seen from
/// one.
bool isLightOfPlaces(const Appearance &appearance, const Material *material)
{
    const auto isPositional
        = [](const Light &light) { return light.kind == Light::Kind::Positional; };
    return std::ranges::any_of(appearance.lights, isPositional)
        || (appearance.viewerKind == Light::Kind::Positional && material
            && material->specular != Colour{{0, 0, 0}});
}

bool hasTexture(const Primitives &primitives, std::size_t triangle, const EffectTruth &what)
{
    const Material *material = materialOf(primitives, triangle);
    return what.texture && material && material->texture;
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
    const bool isForcedOn = appearance.forced[Effect::Antialiasing] == Forcing::On;
    if (isForcedOn && what.antialiasing == Antialiasing::None)
        what.antialiasing = Antialiasing::Samples4;
    return what;
}

bool hasPerspective(const Primitives &primitives, std::size_t triangle, const EffectTruth &what)
{
    const std::array<VertexAttributes, 3> &vertices = attributesOf(primitives, triangle);
    if (!what.perspective || !differ(vertices, &VertexAttributes::w))
        return false;
    const bool isPlaceSeen
        = isLightOfPlaces(primitives.appearance, materialOf(primitives, triangle));
    return (what.smooth && differ(primitives.triangles[triangle].vertices, &Vertex::colour))
        || (what.blending && differ(vertices, &VertexAttributes::alpha))
        || (hasTexture(primitives, triangle, what) && differ(vertices, &VertexAttributes::texture))
        || (isLit(primitives, triangle, what)
            && (differ(vertices, &VertexAttributes::normal)
                || (isPlaceSeen && differ(vertices, &VertexAttributes::place))));
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
