// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shade/triangleneeds.h"

#include "core/shade/commonchannels.h"
#include "core/space/materialcolour.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// Compares values between the vertices that matter for drawing the triangle.
class Carriers {
public:
    explicit Carriers(const Triangle &triangle)
        : m_order(sortedByColumn(triangle))
        , m_isSegment(doubledArea(triangle) == 0)
        , m_isPoint(isPoint(triangle))
    {
    }

    template <class Vertices, class Value>
    bool differIn(const Vertices &vertices, Value value) const
    {
        const auto at = [&](std::size_t place) {
            return std::invoke(value, vertices[std::size_t(m_order[place])]);
        };
        return !agreeInOrder(at, m_isSegment, m_isPoint);
    }

    template <class Vertices, class Value>
    auto leastIn(const Vertices &vertices, Value value) const
    {
        const auto at = [&](std::size_t place) {
            return std::invoke(value, vertices[std::size_t(m_order[place])]);
        };
        return std::min({at(0), at(m_isSegment ? 0 : 1), at(m_isPoint ? 0 : 2)});
    }

private:
    std::array<int, 3> m_order;
    bool m_isSegment = false;
    bool m_isPoint = false;
};

/// Whether light depends on a sample's place: distant lights shine alike everywhere, and so do
/// their highlights for a distant viewer.
bool placeCounts(const Material &material, const Appearance &appearance)
{
    const bool hasHighlight = material.specular != Colour{{0, 0, 0}};
    return (hasHighlight && appearance.viewerKind == Light::Kind::Positional)
        || std::ranges::find(appearance.lights, Light::Kind::Positional, &Light::kind)
        != appearance.lights.end();
}

} // namespace

const Texture *textureOf(const TriangleAttributes &attributes, const Appearance &appearance)
{
    const Material &material = materialOf(appearance, attributes.material);
    const bool hasTexels = material.texture && !material.texture->texels.empty();
    return hasTexels ? material.texture.get() : nullptr;
}

bool hasNormals(const TriangleAttributes &attributes)
{
    return std::ranges::any_of(attributes.vertices, [](const VertexAttributes &vertex) {
        return vertex.normal != std::array<Attribute, 3>{};
    });
}

bool isPoint(const Triangle &triangle)
{
    const auto &[a, b, c] = triangle.vertices;
    return a.position == b.position && b.position == c.position;
}

Colour oneColourOf(const Triangle &triangle)
{
    const bool isSegment = doubledArea(triangle) == 0;
    return triangle.vertices[isSegment ? std::size_t(sortedByColumn(triangle)[0]) : 0].colour;
}

TriangleNeeds needsOf(const Triangle &triangle, const TriangleAttributes *attributes,
                      const Appearance &appearance)
{
    TriangleNeeds needs;
    const Carriers carriers(triangle);
    const auto isSeen = [&](Effect effect) { return appearance.forced[effect] != Forcing::Off; };
    needs.effects.smooth = carriers.differIn(triangle.vertices, &Vertex::colour);
    needs.carriesColour = needs.effects.smooth && isSeen(Effect::SmoothColour);
    if (!attributes)
        return needs;
    const std::array<VertexAttributes, 3> &vertices = attributes->vertices;
    needs.carriesAlpha
        = carriers.differIn(vertices, &VertexAttributes::alpha) && isSeen(Effect::Blending);
    needs.lowestAlpha = carriers.leastIn(vertices, &VertexAttributes::alpha);
    needs.effects.blending = needs.lowestAlpha < 255;
    if (textureOf(*attributes, appearance)) {
        needs.effects.texture = true;
        needs.carriesTexture
            = carriers.differIn(vertices, &VertexAttributes::texture) && isSeen(Effect::Texture);
    }
    const bool isLit = !appearance.lights.empty() && hasNormals(*attributes);
    needs.vertexLight = isLit && appearance.shading != Shading::Phong;
    if (isLit && appearance.shading == Shading::Phong) {
        needs.effects.light = true;
        needs.carriesLight = isSeen(Effect::Light)
            && (carriers.differIn(vertices, &VertexAttributes::normal)
                || (carriers.differIn(vertices, &VertexAttributes::place)
                    && placeCounts(materialOf(appearance, attributes->material), appearance)));
    }
    needs.wDiffers = carriers.differIn(vertices, &VertexAttributes::w);
    needs.effects.perspective = needs.wDiffers && needs.carriesAnything();
    return needs;
}

bool hasHorizon(const Triangle &triangle, const TriangleAttributes *attributes,
                const Appearance &appearance)
{
    return needsOf(triangle, attributes, appearance).effects.perspective
        && appearance.forced[Effect::Perspective] != Forcing::Off;
}

} // namespace pixelplumb
