// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/widerinteger.h"
#include "core/scan/interpolation/interpolationnumbers.h"

namespace pixelplumb {

/// An edge of the bilinear form during the walk: y and all channels where it meets the current
/// column, each changed by adding a rate.
template <class Number, std::size_t channelsInAll = channelCount>
struct ChannelEdge : CarriedCount<channelsInAll> {
    using Vertex = VertexOfChannels<channelsInAll>;

    Number y = {}, slope = {};
    std::array<Number, channelsInAll> channel = {}, rate = {};

    ChannelEdge(const Vertex &a, const Vertex &b, std::int64_t column)
        : CarriedCount<channelsInAll>(a)
    {
        start(y, slope, {a.position.y, b.position.y, yChannel}, a, b, column);
        for (std::size_t i = 0; i < this->carried; ++i)
            start(channel[i], rate[i], {a.channels[i], b.channels[i], i}, a, b, column);
    }

    void stepToNextColumn()
    {
        advance(y, slope);
        for (std::size_t i = 0; i < this->carried; ++i)
            advance(channel[i], rate[i]);
    }

private:
    static constexpr std::size_t yChannel = 0; ///< y has the units of colours

    /// A number's values at a and b, in the units of its channel.
    struct Ends {
        std::int64_t atA = 0, atB = 0;
        std::size_t channel = 0;
    };

    /// A number at the column, and its rate per column; a vertical edge stays at a.
    template <class Integer>
    static void start(FractionOf<Integer> &value, FractionOf<Integer> &perColumn, const Ends &ends,
                      const Vertex &a, const Vertex &b, std::int64_t column)
    {
        const Integer width = Integer(b.position.x) - a.position.x;
        const Integer run = Integer(column) * unitsPerPixel - a.position.x;
        const Integer units = unitsOfChannel(ends.channel);
        const Integer rise = Integer(ends.atB) - ends.atA;
        const bool isVertical = width == 0;
        const Integer denominator = isVertical ? units : width * units;
        value = {isVertical ? Integer(ends.atA) : ends.atA * width + run * rise, denominator};
        perColumn = {isVertical ? Integer(0) : rise * unitsPerPixel, denominator};
    }
    template <FloatingNumber Float>
    static void start(Float &value, Float &perColumn, const Ends &ends, const Vertex &a,
                      const Vertex &b, std::int64_t column)
    {
        const auto real = [](Lattice units) { return NumberTraits<Float>::fromLattice(units); };
        perColumn = a.position.x == b.position.x
            ? Float(0)
            : (realValue<Float>(ends.atB, ends.channel) - realValue<Float>(ends.atA, ends.channel))
                / (real(b.position.x) - real(a.position.x));
        value = realValue<Float>(ends.atA, ends.channel)
            + (Float(column) - real(a.position.x)) * perColumn;
    }
};

/// The rates along a column, (v_T − v_B)/(y_T − y_B), and the values at its first drawn row,
/// v_B + (y − y_B)·Δv; all without rounding.
///
/// With v_B = m_B/d_B, y_B = n_B/d_B and so on, the rate is P/Q with P = m_T·d_B − m_B·d_T and
/// Q = n_T·d_B − n_B·d_T, and the value N/Q with N = m_B(n_T − y·d_T) + m_T(y·d_B − n_B), up to
/// the units. Both are written over the doubled area, which they have as a denominator because they
/// belong to a plane: the divisions leave no remainder. The products take up to 236 bits.
template <class Integer, std::size_t channelsInAll>
void interpolateColumn(const ChannelEdge<FractionOf<Integer>, channelsInAll> &bottom,
                       const ChannelEdge<FractionOf<Integer>, channelsInAll> &top,
                       Int128 doubledArea,
                       InterpolationColumn<FractionOf<Integer>, channelsInAll> &column)
{
    using Wider = TwiceAsWide<Integer>;
    const Integer area = doubledArea;
    const Wider bottomWidth = bottom.y.denominator / unitsPerPixel;
    const Wider topWidth = top.y.denominator / unitsPerPixel;
    const Wider bottomY = bottom.y.numerator;
    const Wider topY = top.y.numerator;
    const Wider height = topY * bottomWidth - bottomY * topWidth;
    const Wider row = Wider(column.firstDrawn) * unitsPerPixel;
    for (std::size_t i = 0; i < bottom.carried; ++i) {
        if (height == 0) {
            column.rate[i] = {Integer(0), bottom.channel[i].denominator};
            column.first[i] = bottom.channel[i];
            continue;
        }
        const Wider low = bottom.channel[i].numerator;
        const Wider high = top.channel[i].numerator;
        const Wider rate = (high * bottomWidth - low * topWidth) * Wider(area) / height;
        const Wider first = (low * (topY - row * topWidth) + high * (row * bottomWidth - bottomY))
            * Wider(area) / height;
        const Integer denominator = area * unitsOfChannel(i);
        column.rate[i] = {Integer(rate) * unitsPerPixel, denominator};
        column.first[i] = {Integer(first), denominator};
    }
}

/// The formulas taken literally, in numbers that round; the rate is 0 where y_B = y_T.
template <FloatingNumber Float, std::size_t channelsInAll>
void interpolateColumn(const ChannelEdge<Float, channelsInAll> &bottom,
                       const ChannelEdge<Float, channelsInAll> &top, Int128,
                       InterpolationColumn<Float, channelsInAll> &column)
{
    const Float height = top.y - bottom.y;
    for (std::size_t i = 0; i < bottom.carried; ++i) {
        column.rate[i]
            = height == Float(0) ? Float(0) : (top.channel[i] - bottom.channel[i]) / height;
        column.first[i]
            = bottom.channel[i] + (Float(column.firstDrawn) - bottom.y) * column.rate[i];
    }
}

} // namespace pixelplumb
