// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/number/widerinteger.h"
#include "core/scan/interpolation/interpolationcoefficients.h"
#include "core/scan/interpolation/interpolationnumbers.h"
#include "core/scan/workstage.h"

/// How an interpolation colours one column.
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

/// A channel of a triangle of zero area at a sample: along L₀₂, its only line.
template <class Number, std::size_t channelsInAll>
Number alongSegment(const InterpolationSetUp<Number, channelsInAll> &setUp, std::size_t channel,
                    std::int64_t x, std::int64_t y)
{
    using Corner = VertexOfChannels<channelsInAll>;
    const Corner &a = setUp.vertices[std::size_t(setUp.order[0])];
    const Corner &b = setUp.vertices[std::size_t(setUp.order[2])];
    const bool isVertical = a.position.x == b.position.x;
    // ChannelEdge walks along x; for a vertical segment y takes its place.
    const auto along = [&](const Corner &vertex) {
        Corner result = vertex;
        result.position.x = isVertical ? vertex.position.y : vertex.position.x;
        return result;
    };
    return ChannelEdge<Number, channelsInAll>(along(a), along(b), isVertical ? y : x)
        .channel[channel];
}

/// Computes a sample's channels from its position. Bilinear channels are added up instead.
template <InterpolationForm Form, class Number, std::size_t channelsInAll>
void evaluate(const InterpolationSetUp<Number, channelsInAll> &setUp, std::int64_t x,
              std::int64_t y, InterpolationSample<Number, channelsInAll> &sample)
{
    if constexpr (Form == InterpolationForm::Plane) {
        for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
            sample.value[channel] = linearAt(setUp.plane[channel], x, y);
    } else if constexpr (Form == InterpolationForm::Barycentric) {
        for (std::size_t i = 0; i < 3; ++i)
            sample.weight[i] = linearAt(setUp.weight[i], x, y);
        for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
            sample.value[channel] = weightedSum(sample.weight, setUp.weighted[channel], channel);
    }
}

/// Colours the rows of one column, bottom to top, with the values that `setSample(y, sample)` sets.
/// Forced inline, like its callers: a call would keep the column's numbers in memory.
template <class Number, std::size_t channelsInAll, class View, class Observer, class SetSample>
[[gnu::always_inline]] inline void colourColumn(
    const InterpolationColumn<Number, channelsInAll> &column, ByteRounding rounding, View frame,
    Observer observer, SetSample setSample)
{
    if (column.firstDrawn >= column.endDrawn)
        return;
    [[maybe_unused]] const WorkScope samples(observer, WorkStage::Pixel);
    InterpolationSample<Number, channelsInAll> sample;
    QRgb *pixel = frame.at(column.x, column.firstDrawn);
    for (std::int64_t y = column.firstDrawn; y < column.endDrawn; ++y) {
        setSample(y, sample);
        for (std::size_t i = 0; i < colourChannelCount; ++i)
            sample.level[i] = levelOf(sample.value[i], rounding);
        const QRgb after = pixelOfLevels(sample.level);
        observer.pixelWritten(column.x, y, *pixel, after, sample);
        *pixel = after;
        pixel += frame.stride;
    }
}

/// Colours one column of a triangle that has area, as the form computes it.
template <InterpolationForm Form, class Number, std::size_t channelsInAll, class View,
          class Observer>
[[gnu::always_inline]] inline void fillInterpolated(
    const InterpolationSetUp<Number, channelsInAll> &setUp,
    const InterpolationColumn<Number, channelsInAll> &column, ByteRounding rounding, View frame,
    Observer observer)
{
    using Sample = InterpolationSample<Number, channelsInAll>;
    if constexpr (isBilinear(Form)) {
        std::array<Number, channelsInAll> value = column.first;
        colourColumn(column, rounding, frame, observer, [&](std::int64_t, Sample &sample) {
            sample.value = value;
            for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
                advance(value[channel], column.rate[channel]);
        });
    } else {
        [[maybe_unused]] const bool isOneColour = hasOneColour(setUp);
        colourColumn(column, rounding, frame, observer, [&](std::int64_t y, Sample &sample) {
            evaluate<Form>(setUp, column.x, y, sample);
            // The sum of rounded weights need not be 1.
            if constexpr (Form == InterpolationForm::Barycentric && FloatingNumber<Number>) {
                for (std::size_t i = 0; isOneColour && i < colourChannelCount; ++i)
                    sample.value[i] = setUp.weighted[i][0];
            }
        });
    }
}

/// Colours one column of a triangle of zero area.
template <class Number, std::size_t channelsInAll, class View, class Observer>
void fillSegment(const InterpolationSetUp<Number, channelsInAll> &setUp,
                 const InterpolationColumn<Number, channelsInAll> &column, ByteRounding rounding,
                 View frame, Observer observer)
{
    using Sample = InterpolationSample<Number, channelsInAll>;
    colourColumn(column, rounding, frame, observer, [&](std::int64_t y, Sample &sample) {
        for (std::size_t channel = 0; channel < setUp.carried(); ++channel)
            sample.value[channel] = alongSegment(setUp, channel, column.x, y);
    });
}

/// Fills a column again, alone, with the same numbers: it reads only the set-up and the column.
template <InterpolationForm Form, class Number, std::size_t channelsInAll, class View,
          class Observer>
void fillAgain(const InterpolationSetUp<Number, channelsInAll> &setUp,
               const InterpolationColumn<Number, channelsInAll> &column, ByteRounding rounding,
               View frame, Observer observer)
{
    if (setUp.zeroArea)
        fillSegment(setUp, column, rounding, frame, observer);
    else
        fillInterpolated<Form>(setUp, column, rounding, frame, observer);
}

} // namespace pixelplumb
