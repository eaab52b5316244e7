// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/attributes.h"
#include "core/geometry/triangle.h"
#include "core/number/commonfraction.h"
#include "core/number/mixednumber.h"
#include "core/scan/columnstate.h"
#include "core/scan/roundedarithmetic.h"
#include "core/scan/spanaxis.h"

#include <algorithm>

/// The numbers that interpolation over a triangle computes with: the channels R G B, z, u v, N_x
/// N_y N_z, as far as they are carried, all treated alike.
namespace pixelplumb {

enum class InterpolationForm {
    Bilinear, ///< along both edges, then along the column, by adding rates
    Plane, ///< v = a·x + b·y + c at each sample
    Barycentric, ///< α·v0 + β·v1 + γ·v2 at each sample
    BilinearRows, ///< as Bilinear, but along rows: in the plane turned to (−y, x)
};

constexpr bool isBilinear(InterpolationForm form)
{
    return form == InterpolationForm::Bilinear || form == InterpolationForm::BilinearRows;
}
constexpr SpanAxis axisOf(InterpolationForm form)
{
    return form == InterpolationForm::BilinearRows ? SpanAxis::Row : SpanAxis::Column;
}

inline constexpr std::size_t channelCount = 9;
/// R G B, the first channels: all that a picture needs.
inline constexpr std::size_t colourChannelCount = 3;

/// How many units make 1 in a channel: 256 for a level, 2^24 for an attribute.
constexpr std::int64_t unitsOfChannel(std::size_t channel)
{
    return channel < colourChannelCount ? unitsPerPixel : attributeOne;
}

/// What triangles carry besides R G B, which all do. Only carried channels are interpolated: they
/// follow R G B, without gaps, in the order z, u v, N_x N_y N_z.
struct CarriedChannels {
    bool depth = false; ///< z
    bool texture = false; ///< u, v
    bool normal = false; ///< N_x, N_y, N_z

    constexpr std::size_t count() const
    {
        return colourChannelCount + (depth ? 1 : 0) + (texture ? 2 : 0) + (normal ? 3 : 0);
    }
};

/// The number of carried channels, the first ones of an array; known at compile time where the
/// array has room for R G B alone.
template <std::size_t channelsInAll>
struct CarriedCount {
    std::size_t carried = channelsInAll;
};
template <>
struct CarriedCount<colourChannelCount> {
    static constexpr std::size_t carried = colourChannelCount;
};

/// A vertex with the values to interpolate, in the channels' units.
template <std::size_t channelsInAll>
struct VertexOfChannels : CarriedCount<channelsInAll> {
    LatticePoint position;
    std::array<std::int64_t, channelsInAll> channels = {};
};

/// Missing attributes are zero.
template <std::size_t channelsInAll>
constexpr VertexOfChannels<channelsInAll> channelVertex(const Vertex &vertex,
                                                        const VertexAttributes *attributes,
                                                        const CarriedChannels &carried)
{
    VertexOfChannels<channelsInAll> result;
    result.position = vertex.position;
    for (std::size_t i = 0; i < colourChannelCount; ++i)
        result.channels[i] = vertex.colour.channels[i] * unitsPerPixel;
    if constexpr (channelsInAll == channelCount) {
        result.carried = carried.count();
        if (!attributes)
            return result;
        std::size_t place = colourChannelCount;
        if (carried.depth)
            result.channels[place++] = attributes->z;
        for (std::size_t i = 0; carried.texture && i < 2; ++i)
            result.channels[place++] = attributes->texture[i];
        for (std::size_t i = 0; carried.normal && i < 3; ++i)
            result.channels[place++] = attributes->normal[i];
    }
    return result;
}

/// A channel's units as a floating number. A level and a position have the same units.
template <FloatingNumber Float>
Float realValue(std::int64_t units, std::size_t channel)
{
    if (channel < colourChannelCount)
        return NumberTraits<Float>::fromLattice(units);
    return Float(double(units) / double(attributeOne)); // exact: it divides by a power of two
}

/// A value that is a floating number already.
template <std::floating_point Float>
Float realValue(Float value, std::size_t)
{
    return value;
}

/// A vertex's value in a channel, as weights multiply it: its units in exact numbers.
template <class Number>
struct VertexValue {
    using Type = std::int64_t;
    static constexpr Type of(std::int64_t units, std::size_t) { return units; }
};
template <FloatingNumber Float>
struct VertexValue<Float> {
    using Type = Float;
    static Type of(std::int64_t units, std::size_t channel)
    {
        return realValue<Float>(units, channel);
    }
};

/// What is computed once for a triangle.
template <class Number, std::size_t channelsInAll = channelCount>
struct InterpolationSetUp {
    std::array<int, 3> order = {0, 1, 2}; ///< indices of P0, P1, P2 in the caller's triangle
    LongEdge longEdge = LongEdge::Above;
    bool zeroArea = false;
    std::array<VertexOfChannels<channelsInAll>, 3> vertices; ///< as the caller gave them
    /// Plane equation: value = a·x + b·y + c, [channel].
    std::array<std::array<Number, 3>, channelsInAll> plane = {};
    /// Barycentric coordinates: weight = a·x + b·y + c, [vertex].
    std::array<std::array<Number, 3>, 3> weight = {};
    /// The values that the weights multiply, [channel][vertex].
    std::array<std::array<typename VertexValue<Number>::Type, 3>, channelsInAll> weighted = {};

    constexpr std::size_t carried() const { return vertices[0].carried; }
};

/// What one column uses.
template <class Number, std::size_t channelsInAll = channelCount>
struct InterpolationColumn {
    std::int64_t x = 0;
    ColumnHalf half = ColumnHalf::First;
    MixedNumber<WideBeside<Number>> lower, upper; ///< where the edges meet the column, exactly, px
    std::int64_t firstRow = 0, endRow = 0; ///< covered: between the two edges
    std::int64_t firstDrawn = 0, endDrawn = 0; ///< the same, clipped to the frame
    Number yBottom = {}, yTop = {}; ///< px, as the bilinear form computes them
    std::array<Number, channelsInAll> bottom = {}, top = {}; ///< on the two edges
    std::array<Number, channelsInAll> rate = {}; ///< per row
    std::array<Number, channelsInAll> first = {}; ///< at firstDrawn
};

/// What one sample has.
template <class Number, std::size_t channelsInAll = channelCount>
struct InterpolationSample {
    std::array<Number, channelsInAll> value = {};
    std::array<Number, 3> weight = {}; ///< α β γ; of the barycentric form
    std::array<std::int64_t, 3> level = {}; ///< R G B rounded, before clamping

    bool isClamped() const
    {
        return std::ranges::any_of(level, [](std::int64_t each) { return each < 0 || each > 255; });
    }
};

template <class N, std::size_t channelsInAll = channelCount>
struct InterpolationNumbers {
    using SetUp = InterpolationSetUp<N, channelsInAll>;
    using Span = InterpolationColumn<N, channelsInAll>;
    using Sample = InterpolationSample<N, channelsInAll>;
};

/// A level's byte before clamping.
template <class Integer>
std::int64_t levelOf(const FractionOf<Integer> &value, ByteRounding rounding)
{
    return std::int64_t(rounding == ByteRounding::Truncate ? value.floor() : value.nearest());
}

template <std::floating_point Float>
std::int64_t levelOf(Float value, ByteRounding rounding)
{
    return RoundedArithmetic<Float>::level(value, rounding);
}

template <class Integer>
void advance(FractionOf<Integer> &value, const FractionOf<Integer> &rate)
{
    value.numerator += rate.numerator;
}

template <FloatingNumber Float>
void advance(Float &value, Float rate)
{
    value = value + rate;
}

} // namespace pixelplumb
