// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"
#include "core/scan/interpolation/interpolationcoefficients.h"
#include "core/scan/walks/columnwalk.h"
#include "core/shade/commonchannels.h"
#include "core/shade/shadedsegment.h"
#include "core/shade/shadingnumber.h"

#include <bit>

namespace pixelplumb {

/// A vertex's value in a channel: levels, or units of 2^-24. 1/w has no value of its own.
constexpr std::int64_t channelUnits(const Vertex &vertex, const VertexAttributes &attributes,
                                    Channel channel)
{
    const std::size_t index = indexOf(channel);
    switch (channel) {
    case Channel::Red:
    case Channel::Green:
    case Channel::Blue:
        return vertex.colour.channels[index];
    case Channel::Alpha:
        return attributes.alpha;
    case Channel::Depth:
        return attributes.z;
    case Channel::Reciprocal:
        return 1;
    case Channel::U:
    case Channel::V:
        return attributes.texture[index - indexOf(Channel::U)];
    case Channel::NormalX:
    case Channel::NormalY:
    case Channel::NormalZ:
        return attributes.normal[index - indexOf(Channel::NormalX)];
    case Channel::PlaceX:
    case Channel::PlaceY:
    case Channel::PlaceZ:
        return attributes.place[index - indexOf(Channel::PlaceX)];
    }
    return 0;
}

/// One triangle with its attributes.
struct ShadedTriangle {
    const Triangle &triangle;
    const TriangleAttributes *attributes = nullptr; ///< null: none; both must outlive this
    DivisionBy division = DivisionBy::W;

    std::int64_t valueAt(std::size_t vertex, Channel channel) const
    {
        static constexpr VertexAttributes none;
        return channelUnits(triangle.vertices[vertex],
                            attributes ? attributes->vertices[vertex] : none, channel);
    }
    /// Positive; any other value is raised to the smallest positive one.
    std::int64_t wAt(std::size_t vertex) const
    {
        return attributes ? std::max<std::int64_t>(1, attributes->vertices[vertex].w)
                          : attributeOne;
    }
};

/// A vertex in the kernel's numbers. Channels that follow perspective are divided by w; exact ones
/// are multiplied by the other two vertices' w instead, which is the same up to a factor common to
/// the triangle.
template <class N>
struct ShadedCorner {
    LatticePoint position;
    PerChannel<typename N::Number> channels = {};
};

/// The set-up of one triangle. Without area it is that of the segment from P0 to P2: along x, or
/// along y where it lies in one column; the middle vertex is ignored.
template <class N>
struct ShadedSetUp {
    using Number = typename N::Number;

    std::array<int, 3> order = {0, 1, 2}; ///< indices of P0, P1, P2 in the caller's triangle
    LongEdge longEdge = LongEdge::Above;
    bool zeroArea = false;
    InterpolationForm form = InterpolationForm::Bilinear;
    EffectSet effects;
    ShadedChannels carried{{}}; ///< the channels that the effects read
    /// Channels in which the vertices agree: they have that value everywhere, whatever the form and
    /// the arithmetic. 1/w is among them where there is nothing to correct: it is 1 then.
    PerChannel<bool> isCommon = {};
    std::array<ShadedCorner<N>, 3> vertices; ///< in the caller's order
    /// The exact denominator: doubled area, unsigned, in square lattice units; for a segment its
    /// length along the axis, lattice units; for a point 1.
    Number area = {};
    /// The plane of a channel, a·x + b·y + c; in exact numbers over the area.
    PerChannel<std::array<Number, 3>> plane = {};
    /// The weight of a vertex, a·x + b·y + c; in exact numbers over the area.
    std::array<std::array<Number, 3>, 3> weight = {};

    /// Whether the channel is divided by w at the vertices.
    bool divides(std::size_t channel) const
    {
        return effects.perspective && channelAt(channel) != Channel::Depth && !isCommon[channel]
            && !isCommon[indexOf(Channel::Reciprocal)];
    }
    /// A vertex that has the common values.
    std::size_t commonVertex() const { return zeroArea ? std::size_t(order[0]) : 0; }
    const Number &commonValue(std::size_t channel) const
    {
        return vertices[commonVertex()].channels[channel];
    }
};

/// The set-up with the vertices' data, for observers that read numbers.
template <class N>
struct ShadedSetUpRead : ShadedSetUp<N> {
    std::array<Vertex, 3> corners;
    std::array<VertexAttributes, 3> attributes; ///< in the caller's order
    int material = noMaterial;
};

/// The number of bits of the magnitude.
constexpr int bitsOf(std::int64_t value)
{
    return int(std::bit_width(std::uint64_t(absolute(value))));
}

/// The three vertices' w without their common powers of two: only ratios matter.
inline std::array<std::int64_t, 3> reducedW(const ShadedTriangle &triangle)
{
    std::array<std::int64_t, 3> w = {triangle.wAt(0), triangle.wAt(1), triangle.wAt(2)};
    const int zeros = std::countr_zero(std::uint64_t(w[0] | w[1] | w[2]));
    for (std::int64_t &each : w)
        each >>= zeros;
    return w;
}

/// Whether 128 bits hold every numerator of the triangle. Twice a numerator is a sum of three
/// products of a form of the edges (a doubled area, or a coefficient times a coordinate), of
/// w_j·w_k, and of a value; a texel's position needs 26 bits besides the denominator. With area
/// antialiasing, a sample outside the triangle by less than a pixel adds two.
inline bool fitsNarrowShading(const ShadedTriangle &triangle, const EffectSet &effects)
{
    if (integerWidthFor(triangle.triangle) != IntegerWidth::Bits64)
        return false;
    constexpr int ofTexel = attributeFractionBits + 2;
    int ofValue = effects.texture ? ofTexel : 8;
    forEachChannel(effects, [&](std::size_t channel) {
        for (std::size_t vertex = 0; vertex < 3; ++vertex)
            ofValue = std::max(ofValue, bitsOf(triangle.valueAt(vertex, channelAt(channel))));
    });
    int ofW = 0;
    if (effects.perspective) {
        const auto w = reducedW(triangle);
        const std::array<int, 3> bits = {bitsOf(w[0]), bitsOf(w[1]), bitsOf(w[2])};
        ofW = bits[0] + bits[1] + bits[2] - *std::ranges::min_element(bits);
    }
    std::int64_t farthest = 1;
    std::int64_t longest = 1;
    for (const auto axis : {&LatticePoint::x, &LatticePoint::y}) {
        const auto &v = triangle.triangle.vertices;
        const auto [low, high]
            = std::minmax({v[0].position.*axis, v[1].position.*axis, v[2].position.*axis});
        farthest = std::max({farthest, absolute(low), absolute(high)});
        longest = std::max(longest, high - low);
    }
    const int ofForm = bitsOf(longest) + bitsOf(farthest + unitsPerPixel) + 1;
    return 1 + ofForm + ofW + ofValue + 2 + 2 < 127;
}

namespace shadedsetup {

template <class Integer>
void setWeights(ShadedSetUp<ExactShading<Integer>> &setUp)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const FacingLine<Integer> line(setUp.vertices, i);
        const Integer sign = line.sign();
        setUp.area = sign * line.there;
        setUp.weight[i]
            = {sign * line.a * unitsPerPixel, sign * line.b * unitsPerPixel, sign * line.c};
    }
}

template <class Integer>
void setNumbers(ShadedSetUp<ExactShading<Integer>> &setUp, const ShadedTriangle &triangle)
{
    const auto w = reducedW(triangle);
    if (setUp.zeroArea)
        setSegmentWeights(setUp);
    else
        setWeights(setUp);
    /// The factor for each vertex's values: the product of the other two w.
    std::array<Integer, 3> factor;
    for (std::size_t i = 0; i < 3; ++i)
        factor[i] = Integer(w[(i + 1) % 3]) * w[(i + 2) % 3];
    for (const std::size_t channel : setUp.carried) {
        std::array<Integer, 3> &plane = setUp.plane[channel];
        plane = {Integer(0), Integer(0), Integer(0)};
        for (std::size_t i = 0; i < 3; ++i) {
            Integer &value = setUp.vertices[i].channels[channel];
            value = triangle.valueAt(i, channelAt(channel));
            if (setUp.divides(channel))
                value *= factor[i];
            for (std::size_t k = 0; k < 3; ++k)
                plane[k] += value * setUp.weight[i][k];
        }
    }
}

template <std::floating_point Float>
void setNumbers(ShadedSetUp<FloatShading<Float>> &setUp, const ShadedTriangle &triangle)
{
    for (const std::size_t channel : setUp.carried) {
        const Channel which = channelAt(channel);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t units = triangle.valueAt(i, which);
            const Float value = isLevel(which) || which == Channel::Reciprocal
                ? Float(units)
                : Float(double(units) / double(attributeOne));
            const auto w = Float(double(triangle.wAt(i)) / double(attributeOne));
            setUp.vertices[i].channels[channel] = setUp.divides(channel) ? value / w : value;
        }
    }
}

/// Sets the coefficients of floating forms; exact forms have them already.
template <std::floating_point Float>
void setForm(ShadedSetUp<FloatShading<Float>> &setUp)
{
    if (setUp.zeroArea) {
        setSegmentForm(setUp);
    } else if (setUp.form == InterpolationForm::Plane) {
        for (const std::size_t channel : setUp.carried) {
            if (setUp.isCommon[channel])
                setUp.plane[channel] = {0, 0, setUp.commonValue(channel)};
            else
                setUp.plane[channel] = planeForm<Float>(setUp.vertices, channel);
        }
    } else if (setUp.form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            setUp.weight[i] = weightForm<Float>(setUp.vertices, i);
    }
}
template <class Integer>
void setForm(ShadedSetUp<ExactShading<Integer>> &)
{
}

} // namespace shadedsetup

template <class N>
ShadedSetUp<N> shadedSetUpOf(InterpolationForm form, const ShadedTriangle &triangle,
                             const EffectSet &effects)
{
    ShadedSetUp<N> setUp;
    setUp.form = form;
    setUp.effects = effects;
    setUp.carried = ShadedChannels(effects);
    const ColumnRange range = columnRangeOf(triangle.triangle, Interval::Closed);
    setUp.order = range.order;
    setUp.longEdge = range.longEdge;
    setUp.zeroArea = range.zeroArea;
    for (std::size_t i = 0; i < 3; ++i)
        setUp.vertices[i].position = triangle.triangle.vertices[i].position;
    shadedsetup::setCommonChannels(setUp, triangle);
    shadedsetup::setNumbers(setUp, triangle);
    shadedsetup::setForm(setUp);
    return setUp;
}

} // namespace pixelplumb
