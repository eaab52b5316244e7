// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/interpolationnumbers.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace pixelplumb {

/// An edge under way in the bilinear form: y and all channels where it meets the current column,
/// each changed by adding a rate.
template <class Number>
struct ChannelEdge {
    Number y = {}, slope = {};
    std::array<Number, channelCount> channel = {}, rate = {};

    ChannelEdge(const ChannelVertex &a, const ChannelVertex &b, std::int64_t column)
    {
        start(y, slope, a.position.y, b.position.y, a, b, column);
        for (std::size_t i = 0; i < channelCount; ++i)
            start(channel[i], rate[i], a.channels[i], b.channels[i], a, b, column);
    }

    void stepToNextColumn()
    {
        advance(y, slope);
        for (std::size_t i = 0; i < channelCount; ++i)
            advance(channel[i], rate[i]);
    }

private:
    /// A number at the column, from its values at a and b in units of 1/256, and its rate per
    /// column; a vertical edge stays at a.
    static void start(Ratio &value, Ratio &perColumn, Lattice atA, Lattice atB,
                      const ChannelVertex &a, const ChannelVertex &b, std::int64_t column)
    {
        const Int128 width = b.position.x - a.position.x;
        const Int128 run = Int128(column) * unitsPerPixel - a.position.x;
        const Int128 denominator = (width == 0 ? 1 : width) * unitsPerPixel;
        value = {width == 0 ? Int128(atA) : atA * width + run * (atB - atA), denominator};
        perColumn = {width == 0 ? Int128(0) : Int128(atB - atA) * unitsPerPixel, denominator};
    }
    template <std::floating_point Float>
    static void start(Float &value, Float &perColumn, Lattice atA, Lattice atB,
                      const ChannelVertex &a, const ChannelVertex &b, std::int64_t column)
    {
        const auto real = [](Lattice units) { return NumberTraits<Float>::fromLattice(units); };
        perColumn = a.position.x == b.position.x
            ? Float(0)
            : (real(atB) - real(atA)) / (real(b.position.x) - real(a.position.x));
        value = real(atA) + (Float(column) - real(a.position.x)) * perColumn;
    }
};

/// The rates along a column, (v_T − v_B)/(y_T − y_B), and the values at its first drawn row,
/// v_B + (y − y_B)·Δv; all without rounding.
///
/// With v_B = m_B/d_B, y_B = n_B/d_B and so on, the rate is P/Q with P = m_T·d_B − m_B·d_T and
/// Q = n_T·d_B − n_B·d_T, and the value N/Q with N = m_B(n_T − y·d_T) + m_T(y·d_B − n_B), up to
/// the units. Both are written over the doubled area, which they have as a denominator because they
/// belong to a plane: the divisions leave no remainder. The products take up to 236 bits.
inline void interpolateColumn(const ChannelEdge<Ratio> &bottom, const ChannelEdge<Ratio> &top,
                              Int128 area, InterpolationColumn<Ratio> &column)
{
    using Wide = boost::multiprecision::int256_t;
    const Wide bottomWidth = bottom.y.denominator / unitsPerPixel;
    const Wide topWidth = top.y.denominator / unitsPerPixel;
    const Wide bottomY = bottom.y.numerator;
    const Wide topY = top.y.numerator;
    const Wide height = topY * bottomWidth - bottomY * topWidth;
    const Wide row = Wide(column.firstDrawn) * unitsPerPixel;
    for (std::size_t i = 0; i < channelCount; ++i) {
        if (height == 0) {
            column.rate[i] = {0, bottom.channel[i].denominator};
            column.first[i] = bottom.channel[i];
            continue;
        }
        const Wide low = bottom.channel[i].numerator;
        const Wide high = top.channel[i].numerator;
        const Wide rate = (high * bottomWidth - low * topWidth) * area / height;
        const Wide first = (low * (topY - row * topWidth) + high * (row * bottomWidth - bottomY))
            * area / height;
        column.rate[i] = {Int128(rate) * unitsPerPixel, area * unitsPerPixel};
        column.first[i] = {Int128(first), area * unitsPerPixel};
    }
}

/// The same to the letter, in numbers that round; 0 where y_B = y_T.
template <std::floating_point Float>
void interpolateColumn(const ChannelEdge<Float> &bottom, const ChannelEdge<Float> &top, Int128,
                       InterpolationColumn<Float> &column)
{
    const Float height = top.y - bottom.y;
    for (std::size_t i = 0; i < channelCount; ++i) {
        column.rate[i]
            = height == Float(0) ? Float(0) : (top.channel[i] - bottom.channel[i]) / height;
        column.first[i]
            = bottom.channel[i] + (Float(column.firstDrawn) - bottom.y) * column.rate[i];
    }
}

} // namespace pixelplumb
