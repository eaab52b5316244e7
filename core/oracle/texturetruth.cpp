// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/oracle/texturetruth.h"

namespace pixelplumb::oracle {

namespace {

/// Moves an index outside the picture into it.
std::int32_t wrapped(const BigInteger &index, std::int32_t size, TextureWrap wrap)
{
    if (wrap == TextureWrap::Repeat) {
        const auto pictures = floorDivide<BigInteger>(index, size);
        return BigInteger(index - pictures * size).convert_to<std::int32_t>();
    }
    if (index < 0)
        return 0;
    return index < size ? index.convert_to<std::int32_t>() : size - 1;
}

/// The texels around a texture coordinate: the first, and how far it is towards the next.
struct TexelPlace {
    BigInteger first;
    WideFraction towardsNext; ///< 0 … 1
};

/// The texels around t·size − ½.
TexelPlace placeBetween(const WideFraction &t, std::int32_t size)
{
    const WideFraction place = {2 * size * t.numerator - t.denominator, 2 * t.denominator};
    const BigInteger first = place.floor();
    return {first, {place.numerator - first * place.denominator, place.denominator}};
}

WeightedTexel texelOf(const Material &material, const BigInteger &i, const BigInteger &j,
                      const WideFraction &weight)
{
    const Texture &texture = *material.texture;
    const std::int32_t column = wrapped(i, texture.width, material.wrap);
    const std::int32_t row = wrapped(j, texture.height, material.wrap);
    return {column, row, weight, texture.texel(column, row)};
}

bool isWhole(const Texture &texture)
{
    return texture.width > 0 && texture.height > 0
        && texture.texels.size() >= std::size_t(texture.width) * std::size_t(texture.height);
}

} // namespace

std::vector<WeightedTexel> texelsAt(const Material &material, const WideFraction &u,
                                    const WideFraction &v)
{
    if (!material.texture || !isWhole(*material.texture))
        return {};
    const Texture &texture = *material.texture;
    if (material.filter == TextureFilter::Nearest) {
        const WideFraction column = {u.numerator * texture.width, u.denominator};
        const WideFraction row = {v.numerator * texture.height, v.denominator};
        return {texelOf(material, column.floor(), row.floor(), {1, 1})};
    }
    const TexelPlace across = placeBetween(u, texture.width);
    const TexelPlace upward = placeBetween(v, texture.height);
    const BigInteger whole = across.towardsNext.denominator * upward.towardsNext.denominator;
    std::vector<WeightedTexel> texels;
    for (const int up : {0, 1}) {
        for (const int right : {0, 1}) {
            const WideFraction alongU = right == 1 ? across.towardsNext : 1 - across.towardsNext;
            const WideFraction alongV = up == 1 ? upward.towardsNext : 1 - upward.towardsNext;
            texels.push_back(texelOf(material, across.first + right, upward.first + up,
                                     {alongU.numerator * alongV.numerator, whole}));
        }
    }
    return texels;
}

Colour textureByte(const std::vector<WeightedTexel> &texels)
{
    Colour colour;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        WideFraction level = {0, texels.front().weight.denominator};
        for (const WeightedTexel &texel : texels)
            level.numerator += texel.weight.numerator * texel.colour.channels[channel];
        colour.channels[channel] = byteOf(level, ByteRounding::Nearest);
    }
    return colour;
}

Colour modulated(const Colour &colour, const Colour &by)
{
    Colour product;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const int level = colour.channels[channel] * by.channels[channel];
        product.channels[channel] = std::uint8_t((2 * level + 255) / 510);
    }
    return product;
}

} // namespace pixelplumb::oracle
