// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/exactsample.h"

#include "core/number/widequantity.h"

namespace pixelplumb::oracle {

namespace {

/// Converts a number in Attribute's format to the number itself.
WideFraction plainly(const WideFraction &attribute)
{
    return {attribute.numerator, attribute.denominator * attributeOne};
}

/// One number from each of the three vertices.
template <class Vertices, class Reader>
std::array<std::int64_t, 3> each(const Vertices &vertices, const Reader &read)
{
    return {read(vertices[0]), read(vertices[1]), read(vertices[2])};
}

} // namespace

std::optional<ExactSample> exactSampleAt(const Primitives &primitives, std::size_t triangle,
                                         const Triangle &moved, ByteRounding rounding,
                                         const EffectTruth &what, std::int64_t x, std::int64_t y)
{
    const std::array<VertexAttributes, 3> &vertices = attributesOf(primitives, triangle);
    const Material *material = materialOf(primitives, triangle);
    ExactSample sample;
    sample.weights
        = doubledArea(moved) == 0 ? segmentWeights(moved, x, y) : barycentricWeights(moved, x, y);
    sample.attributeWeights = hasPerspective(primitives, triangle, what)
        ? perspectiveWeights(sample.weights, vertices)
        : sample.weights;
    if (sample.attributeWeights.whole <= 0)
        return std::nullopt;
    const PlaneWeights &weights = sample.attributeWeights;
    sample.z = plainly(
        sample.weights.mean(each(vertices, [](const VertexAttributes &of) { return of.z; })));

    const Vertex &first = doubledArea(moved) == 0
        ? *std::ranges::min_element(moved.vertices, {}, &Vertex::position)
        : moved.vertices[0];
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto levelAt = [&](const Vertex &of) {
            return std::int64_t((what.smooth ? of : first).colour.channels[channel]);
        };
        sample.levels[channel] = weights.mean(each(moved.vertices, levelAt));
        sample.interpolated.channels[channel] = byteOf(sample.levels[channel], rounding);
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        sample.texture[axis] = plainly(weights.mean(
            each(vertices, [&](const VertexAttributes &of) { return of.texture[axis]; })));
    }

    sample.textured = sample.interpolated;
    if (what.texture && material)
        sample.texels = texelsAt(*material, sample.texture[0], sample.texture[1]);
    if (!sample.texels.empty())
        sample.textured = modulated(sample.interpolated, textureByte(sample.texels));
    sample.colour = sample.textured;
    if (isLit(primitives, triangle, what)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sample.normal[axis] = weights.mean(
                each(vertices, [&](const VertexAttributes &of) { return of.normal[axis]; }));
            sample.place[axis] = weights.mean(
                each(vertices, [&](const VertexAttributes &of) { return of.place[axis]; }));
        }
        sample.lit = litColour(sample.textured, sample.normal, sample.place, primitives.appearance,
                               material);
        sample.colour = sample.lit->colour;
    }
    sample.alphaLevel = weights.mean(
        each(vertices, [](const VertexAttributes &of) { return std::int64_t(of.alpha); }));
    if (what.blending)
        sample.alpha = byteOf(sample.alphaLevel, rounding);
    return sample;
}

WideFraction keptDepth(const WideFraction &z, DepthFormat format)
{
    if (format == DepthFormat::Exact)
        return z;
    const std::int64_t farthest = (std::int64_t(1) << int(format)) - 1;
    if (z.numerator <= 0)
        return {0, 1};
    if (z.numerator >= z.denominator)
        return {farthest, 1};
    return {WideFraction{z.numerator * farthest, z.denominator}.nearest(), 1};
}

std::uint8_t sharedAlpha(std::uint8_t alpha, const BigRational &area)
{
    return byteOf({alpha * numerator(area), denominator(area)}, ByteRounding::Nearest);
}

bool isNoFarther(const WideFraction &a, const WideFraction &b)
{
    return a.numerator * b.denominator <= b.numerator * a.denominator;
}

std::array<Quantity, 3> colourLevelsAt(const Primitives &primitives, std::size_t triangle,
                                       const EffectTruth &what, std::int64_t x, std::int64_t y)
{
    EffectTruth colourAlone;
    colourAlone.smooth = what.smooth;
    colourAlone.perspective = what.perspective;
    colourAlone.texture = colourAlone.light = colourAlone.blending = false;
    const Triangle &seen = primitives.triangles[triangle];
    const std::optional<ExactSample> exact
        = exactSampleAt(primitives, triangle, seen, ByteRounding::Nearest, colourAlone, x, y);
    std::array<Quantity, 3> levels;
    for (std::size_t channel = 0; exact && channel < 3; ++channel)
        levels[channel]
            = quotientOf(exact->levels[channel].numerator, exact->levels[channel].denominator);
    return levels;
}

} // namespace pixelplumb::oracle
