// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/vertexlight.h"

#include "core/number/naturalpower.h"
#include "core/space/attributenumber.h"
#include "core/space/exactreal.h"

#include <algorithm>

namespace pixelplumb {

namespace {

/// The unit vector towards a light or the viewer: from the point to a position, or a direction.
template <class Number>
SpaceVector<Number> towards(Light::Kind kind, const SpaceVector<Number> &at,
                            const SpaceVector<Number> &point)
{
    return unit(kind == Light::Kind::Positional ? at - point : at);
}

/// The unit vector towards the light, opposite to the direction in which a directional one shines.
template <class Number>
SpaceVector<Number> towardsLight(const Light &light, const SpaceVector<Number> &point)
{
    const auto at = spaceVectorOf<Number>(light.at);
    return towards(light.kind,
                   light.kind == Light::Kind::Directional ? SpaceVector<Number>() - at : at, point);
}

Colour bytesOf(const std::array<double, 3> &levels)
{
    return {{levelByte(levels[0]), levelByte(levels[1]), levelByte(levels[2])}};
}

Colour meanColour(const Triangle &triangle)
{
    Colour mean;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (const Vertex &vertex : triangle.vertices)
            sum += vertex.colour.channels[channel];
        mean.channels[channel] = std::uint8_t((2 * sum + 3) / 6);
    }
    return mean;
}

void light(Triangle &triangle, const TriangleAttributes &attributes, const Appearance &appearance)
{
    const Material &material = materialOf(appearance, attributes.material);
    const auto lit = litColoursOf<double>(triangle, attributes, appearance.shading);
    for (std::size_t i = 0; i < 3; ++i) {
        const LitColour<double> &from = lit[std::min(i, lit.size() - 1)];
        triangle.vertices[i].colour
            = bytesOf(litLevels(appearance, material, from.colour, from.point));
    }
}

} // namespace

template <class Number>
std::vector<LitColour<Number>> litColoursOf(const Triangle &triangle,
                                            const TriangleAttributes &attributes, Shading shading)
{
    std::vector<LitColour<Number>> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const VertexAttributes &vertex = attributes.vertices[i];
        corners.push_back(
            {triangle.vertices[i].colour,
             {spaceVectorOf<Number>(vertex.place), unit(spaceVectorOf<Number>(vertex.normal))}});
    }
    if (shading == Shading::Gouraud)
        return corners;
    LitColour<Number> centre{meanColour(triangle), {}};
    for (const LitColour<Number> &corner : corners) {
        centre.point.place = centre.point.place + Number(1) / 3 * corner.point.place;
        centre.point.normal = centre.point.normal + corner.point.normal;
    }
    return {centre};
}
template std::vector<LitColour<double>> litColoursOf(const Triangle &, const TriangleAttributes &,
                                                     Shading);
template std::vector<LitColour<ExactReal>> litColoursOf(const Triangle &,
                                                        const TriangleAttributes &, Shading);

template <class Number>
LightVectors<Number> lightVectors(const Appearance &appearance, const Light &light,
                                  const LitPoint<Number> &point)
{
    LightVectors<Number> vectors;
    vectors.normal = unit(point.normal);
    vectors.toLight = towardsLight<Number>(light, point.place);
    vectors.toViewer
        = towards(appearance.viewerKind, spaceVectorOf<Number>(appearance.viewer), point.place);
    // Without a viewer there is no half-way vector.
    if (!vectors.toViewer.isZero())
        vectors.halfway = unit(vectors.toLight + vectors.toViewer);
    return vectors;
}

template <class Number>
LightTerm<Number> lightTerm(const Appearance &appearance, const Light &light, int shininess,
                            const LitPoint<Number> &point)
{
    const LightVectors<Number> vectors = lightVectors(appearance, light, point);
    LightTerm<Number> term;
    term.diffuse = dot(vectors.normal, vectors.toLight);
    if (!(term.diffuse > 0))
        return {};
    const Number highlight = dot(vectors.normal, vectors.halfway);
    if (highlight > 0)
        term.specular = naturalPower(highlight, shininess);
    return term;
}

template <class Number>
std::array<Number, 3> litLevels(const Appearance &appearance, const Material &material,
                                const Colour &colour, const LitPoint<Number> &point)
{
    std::array<Number, 3> diffuse;
    std::array<Number, 3> specular;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        diffuse[channel] = Number(appearance.ambient.channels[channel]);
        specular[channel] = Number(0);
    }
    for (const Light &each : appearance.lights) {
        const LightTerm<Number> term = lightTerm(appearance, each, material.shininess, point);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const Number level(each.colour.channels[channel]);
            diffuse[channel] += level * term.diffuse;
            specular[channel] += level * term.specular;
        }
    }
    std::array<Number, 3> levels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        levels[channel] = (Number(colour.channels[channel]) * diffuse[channel]
                           + Number(material.specular.channels[channel]) * specular[channel])
            / 255;
    }
    return levels;
}

template LightVectors<double> lightVectors(const Appearance &, const Light &,
                                           const LitPoint<double> &);
template LightVectors<ExactReal> lightVectors(const Appearance &, const Light &,
                                              const LitPoint<ExactReal> &);
template LightTerm<double> lightTerm(const Appearance &, const Light &, int,
                                     const LitPoint<double> &);
template LightTerm<ExactReal> lightTerm(const Appearance &, const Light &, int,
                                        const LitPoint<ExactReal> &);
template std::array<double, 3> litLevels(const Appearance &, const Material &, const Colour &,
                                         const LitPoint<double> &);
template std::array<ExactReal, 3> litLevels(const Appearance &, const Material &, const Colour &,
                                            const LitPoint<ExactReal> &);

void tint(Triangle &triangle, const Material &material)
{
    if (material.diffuse == Material().diffuse)
        return;
    for (Vertex &vertex : triangle.vertices)
        vertex.colour = tinted(vertex.colour, material.diffuse);
}

bool lightsVertices(const Appearance &appearance)
{
    return appearance.shading != Shading::Phong && !appearance.lights.empty()
        && appearance.forced[Effect::Light] != Forcing::Off;
}

void lightPlainTriangles(std::vector<Triangle> &triangles,
                         std::vector<TriangleAttributes> &attributes, const Appearance &appearance)
{
    for (TriangleAttributes &each : attributes) {
        Triangle &triangle = triangles[each.triangle];
        const Material &material = materialOf(appearance, each.material);
        tint(triangle, material);
        const bool hasNormals
            = std::ranges::any_of(each.vertices, [](const VertexAttributes &vertex) {
                  return vertex.normal != std::array<Attribute, 3>{};
              });
        if ((appearance.lights.empty() && !lightsVertices(appearance)) || !hasNormals)
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr auto perPixel = double(unitsPerPixel);
            const LatticePoint &position = triangle.vertices[i].position;
            each.vertices[i].place
                = {clampedAttribute(double(position.x) / perPixel),
                   clampedAttribute(double(position.y) / perPixel), each.vertices[i].z};
        }
        if (lightsVertices(appearance))
            light(triangle, each, appearance);
    }
}

} // namespace pixelplumb
