// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/frame/levelpixel.h"
#include "core/scan/interpolation/interpolationcoefficients.h"
#include "core/scan/interpolation/interpolationedge.h"
#include "core/scan/workstage.h"

/// How an interpolation colours one column.
namespace pixelplumb {

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
