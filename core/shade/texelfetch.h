// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/levelpixel.h"
#include "core/geometry/appearance.h"
#include "core/number/wholenumber.h"
#include "core/number/wideinteger.h"
#include "core/shade/shadingnumber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

/// Which texels a sample reads, and the colour that they produce.
namespace pixelplumb {

/// A texel's index inside the texture.
constexpr std::int32_t wrapped(std::int64_t index, std::int32_t size, TextureWrap wrap)
{
    if (wrap == TextureWrap::Clamp)
        return std::int32_t(std::clamp<std::int64_t>(index, 0, size - 1));
    if (index >= 0 && index < size)
        return std::int32_t(index);
    // Nearly all indices fit 32 bits, where division takes a third of the time.
    const auto narrow = std::int32_t(index);
    const std::int32_t remainder
        = narrow == index ? narrow % size : std::int32_t(index % std::int64_t(size));
    return remainder < 0 ? remainder + size : remainder;
}

/// A sample's position along one side of a texture, in texels: the whole part and the rest, 0 <=
/// rest < 1.
template <class N>
struct TexturePlace;

template <std::floating_point Float>
struct TexturePlace<FloatShading<Float>> {
    std::int64_t whole = 0;
    Float rest = 0;

    /// The position of a coordinate, less `halves` half texels. Positions beyond ±2^30 and NaN
    /// become 0: a texture that repeats so often is noise.
    TexturePlace(Float coordinate, Float, std::int32_t size, int halves)
    {
        const Float texels = coordinate * Float(size) - Float(halves) / 2;
        if (!(std::abs(texels) < Float(1 << 30)))
            return;
        whole = floorOf(texels);
        rest = texels - Float(whole);
    }
};

/// With the coordinate n/(d·2^24), n = q·d + r, twice the texels are 2(q·size + r·size/d)/2^24.
template <class Integer>
struct TexturePlace<ExactShading<Integer>> {
    std::int64_t whole = 0;
    Integer numerator = 0; ///< the rest, over the denominator
    Integer denominator = 1;

    TexturePlace(const Integer &coordinate, const Integer &unit, std::int32_t size, int halves)
        : denominator(unit * one)
    {
        const std::int64_t twice = 2 * std::int64_t(size);
        const Integer quotient = floorDivide<Integer>(coordinate, unit);
        const Integer parts = Integer(coordinate - quotient * unit) * twice;
        const Integer carried = parts / unit;
        const Integer texels = quotient * twice - halves * attributeOne + carried;
        const Integer below = floorDivide<Integer>(texels, Integer(one));
        whole = std::int64_t(below);
        numerator = Integer(texels - below * one) * unit + Integer(parts - carried * unit);
    }

private:
    static constexpr std::int64_t one = 2 * attributeOne;
};

/// What a sample reads from a texture.
template <class N>
struct TexelSample {
    std::array<std::int32_t, 2> first = {}; ///< {i, j} of the texel, or of the lower left of four
    bool isFiltered = false; ///< four texels are read
    std::array<Colour, 4> four = {}; ///< lower left, lower right, upper left, upper right
    std::array<typename N::Real, 2> fraction = {}; ///< from the first texel to its neighbours
    std::array<std::int32_t, 2> size = {}; ///< of the texture
    TextureWrap wrap = TextureWrap::Repeat;
    Colour texel; ///< the resulting colour
};

namespace texelfetch {

template <class Real>
Real mixed(const std::array<Real, 4> &level, const std::array<Real, 2> &fraction)
{
    const Real low = level[0] + (level[1] - level[0]) * fraction[0];
    const Real high = level[2] + (level[3] - level[2]) * fraction[0];
    return low + (high - low) * fraction[1];
}

/// ⌊Σ w·t + ½⌋ with the exact fractions.
template <class Integer>
std::uint8_t exactlyMixed(const std::array<int, 4> &level,
                          const TexturePlace<ExactShading<Integer>> &u,
                          const TexturePlace<ExactShading<Integer>> &v)
{
    const BigInteger a(u.numerator);
    const BigInteger b(v.numerator);
    const BigInteger aRest = BigInteger(u.denominator) - a;
    const BigInteger bRest = BigInteger(v.denominator) - b;
    const BigInteger sum
        = (aRest * level[0] + a * level[1]) * bRest + (aRest * level[2] + a * level[3]) * b;
    const BigInteger unit = BigInteger(u.denominator) * v.denominator;
    return std::uint8_t(BigInteger((2 * sum + unit) / (2 * unit)));
}

/// Reads the four texels around the sample, the first of them already known, and mixes them.
template <class N>
void filterTexels(const Material &material, const TexturePlace<N> &placeU,
                  const TexturePlace<N> &placeV, TexelSample<N> &sample)
{
    using Real = typename N::Real;
    const Texture &texture = *material.texture;
    const std::array<std::int32_t, 2> second
        = {wrapped(placeU.whole + 1, texture.width, material.wrap),
           wrapped(placeV.whole + 1, texture.height, material.wrap)};
    sample.isFiltered = true;
    sample.four = {sample.texel, texture.texel(second[0], sample.first[1]),
                   texture.texel(sample.first[0], second[1]), texture.texel(second[0], second[1])};
    if constexpr (N::isExact)
        sample.fraction = {Real(placeU.numerator) / Real(placeU.denominator),
                           Real(placeV.numerator) / Real(placeV.denominator)};
    else
        sample.fraction = {placeU.rest, placeV.rest};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::array<int, 4> bytes;
        std::array<Real, 4> levels;
        for (std::size_t i = 0; i < 4; ++i) {
            bytes[i] = sample.four[i].channels[channel];
            levels[i] = Real(bytes[i]);
        }
        const Real level = mixed(levels, sample.fraction) + Real(0.5);
        const std::int64_t byte = floorOf(level);
        sample.texel.channels[channel] = std::uint8_t(clampedByte(byte));
        if constexpr (N::isExact) {
            // Doubles are off by less than 2^-40 levels: exact numbers are needed only where that
            // may matter.
            constexpr Real doubt = 1e-9;
            const Real above = level - Real(byte);
            if (above < doubt || above > 1 - doubt)
                sample.texel.channels[channel] = exactlyMixed(bytes, placeU, placeV);
        }
    }
}

} // namespace texelfetch

/// How many texels a sample reads.
constexpr std::size_t texelsOf(TextureFilter filter)
{
    return filter == TextureFilter::Bilinear ? 4 : 1;
}

/// Reads the texture of a material at u, v: in exact numbers, numerators over the denominator.
template <TextureFilter filter, class N>
TexelSample<N> fetchTexels(const Material &material, const typename N::Number &u,
                           const typename N::Number &v, const typename N::Number &denominator)
{
    const Texture &texture = *material.texture;
    constexpr int halves = filter == TextureFilter::Bilinear ? 1 : 0;
    const TexturePlace<N> placeU(u, denominator, texture.width, halves);
    const TexturePlace<N> placeV(v, denominator, texture.height, halves);
    TexelSample<N> sample;
    sample.size = {texture.width, texture.height};
    sample.wrap = material.wrap;
    sample.first = {wrapped(placeU.whole, texture.width, material.wrap),
                    wrapped(placeV.whole, texture.height, material.wrap)};
    sample.texel = texture.texel(sample.first[0], sample.first[1]);
    if constexpr (filter == TextureFilter::Bilinear)
        texelfetch::filterTexels(material, placeU, placeV, sample);
    return sample;
}

} // namespace pixelplumb
