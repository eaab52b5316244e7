// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scenes/effectsample.h"

#include "core/number/widequantity.h"
#include "core/oracle/exactsample.h"
#include "core/oracle/squarearea.h"

namespace pixelplumb::oracle {

namespace {

Quantity quantityOf(const WideFraction &fraction)
{
    return quotientOf(fraction.numerator, fraction.denominator);
}

template <std::size_t Count>
std::array<Quantity, Count> quantitiesOf(const std::array<WideFraction, Count> &fractions)
{
    std::array<Quantity, Count> quantities;
    for (std::size_t i = 0; i < Count; ++i)
        quantities[i] = quantityOf(fractions[i]);
    return quantities;
}

/// Converts numbers in Attribute's format to the numbers themselves.
template <std::size_t Count>
std::array<Quantity, Count> plainQuantities(std::array<WideFraction, Count> attributes)
{
    for (WideFraction &attribute : attributes)
        attribute.denominator *= attributeOne;
    return quantitiesOf(attributes);
}

/// Σ λ/w.
Quantity reciprocalW(const PlaneWeights &barycentric,
                     const std::array<VertexAttributes, 3> &vertices)
{
    const PlaneWeights seen = perspectiveWeights(barycentric, vertices);
    BigInteger product = barycentric.whole;
    for (const VertexAttributes &vertex : vertices)
        product *= vertex.w;
    return product > 0 ? quantityOf({seen.whole * attributeOne, product}) : Quantity();
}

} // namespace

std::optional<EffectSample> effectSampleAt(const Primitives &primitives, std::size_t triangle,
                                           ByteRounding rounding, const EffectTruth &what,
                                           std::int64_t x, std::int64_t y)
{
    const Triangle &seen = primitives.triangles[triangle];
    const std::optional<ExactSample> exact
        = exactSampleAt(primitives, triangle, seen, rounding, what, x, y);
    if (!exact)
        return std::nullopt;
    const std::array<VertexAttributes, 3> &vertices = attributesOf(primitives, triangle);
    const BigRational area = areaInSquare(seen, x, y);
    EffectSample sample;
    sample.area = quantityOf({numerator(area), denominator(area)});
    for (std::size_t i = 0; i < 3; ++i)
        sample.weights[i] = quantityOf({exact->weights.parts[i], exact->weights.whole});
    sample.z = quantityOf(exact->z);
    sample.depth = quantityOf(keptDepth(exact->z, primitives.appearance.depthFormat));
    sample.reciprocalW = reciprocalW(exact->weights, vertices);
    sample.levels = quantitiesOf(exact->levels);
    sample.interpolated = exact->interpolated;
    sample.texture = quantitiesOf(exact->texture);
    std::array<WideFraction, 2> affine;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        affine[axis] = exact->weights.mean(
            {vertices[0].texture[axis], vertices[1].texture[axis], vertices[2].texture[axis]});
    }
    sample.affineTexture = plainQuantities(affine);
    for (const WeightedTexel &texel : exact->texels)
        sample.texels.push_back({texel.i, texel.j, quantityOf(texel.weight), texel.colour});
    sample.textured = exact->textured;
    if (exact->lit) {
        sample.normal = plainQuantities(exact->normal);
        sample.place = plainQuantities(exact->place);
    }
    sample.lit = exact->lit;
    sample.colour = exact->colour;
    sample.alphaLevel = quantityOf(exact->alphaLevel);
    sample.alpha = exact->alpha;
    const bool isShared = what.antialiasing == Antialiasing::Area && doubledArea(seen) != 0;
    sample.sharedAlpha = isShared ? sharedAlpha(exact->alpha, area) : exact->alpha;
    return sample;
}

} // namespace pixelplumb::oracle
