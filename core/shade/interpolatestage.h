// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

#include <algorithm>

/// The first stage: each channel's value at the samples, in one of three forms.
namespace pixelplumb::stages {

template <class N>
void readValues(const StagedSamples<N> &run)
{
    for (std::size_t i = 0; run.read && i < run.size; ++i) {
        for (const std::size_t channel : *run.carried)
            run.read[i].value[channel] = run.value[channel][i];
    }
}

/// A channel's value at the row where adding begins.
template <class N>
typename N::Number startOf(const StagedSamples<N> &run, std::size_t channel)
{
    using Number = typename N::Number;
    const ShadedColumn<N> &column = *run.column;
    if constexpr (N::isExact)
        return column.atRow0[channel] + Number(run.start) * column.rate[channel];
    else
        return column.bottom[channel] + (Number(run.start) - column.yBottom) * column.rate[channel];
}

/// Adds up `width` channels side by side: each addition waits for the one before it, but not for
/// those of other channels.
template <std::size_t width, class N>
void addUp(StagedSamples<N> &run, const std::uint8_t *channels)
{
    using Number = typename N::Number;
    std::array<Number, width> value, rate;
    std::array<Number *, width> values;
    for (std::size_t i = 0; i < width; ++i) {
        const std::size_t channel = channels[i];
        value[i] = run.firstRow == run.start ? startOf(run, channel) : run.next[channel];
        rate[i] = run.column->rate[channel];
        values[i] = run.value[channel].data();
    }
    // A short loop lets the processor begin with later work while it waits.
    const std::size_t count = run.count;
#pragma GCC unroll 8
    for (std::size_t sample = 0; sample < count; ++sample) {
        for (std::size_t i = 0; i < width; ++i) {
            values[i][sample] = value[i];
            value[i] = value[i] + rate[i];
        }
    }
    for (std::size_t i = 0; i < width; ++i)
        run.next[channels[i]] = value[i];
}

template <class N>
void interpolateByAdding(StagedSamples<N> &run)
{
    const std::uint8_t *channel = run.carried->begin();
    const std::uint8_t *const end = run.carried->end();
    for (; end - channel >= 4; channel += 4)
        addUp<4>(run, channel);
    switch (end - channel) {
    case 3:
        addUp<3>(run, channel);
        break;
    case 2:
        addUp<2>(run, channel);
        break;
    case 1:
        addUp<1>(run, channel);
        break;
    }
    readValues(run);
}

/// a·x + b·y + c at the samples.
template <class N>
void evaluate(const StagedSamples<N> &run, const std::array<typename N::Number, 3> &form,
              typename N::Number *values)
{
    using Number = typename N::Number;
    const Number alongX = form[0] * Number(run.column->x);
    for (std::size_t i = 0; i < run.count; ++i)
        values[i] = alongX + form[1] * Number(run.firstRow + std::int64_t(i)) + form[2];
}

template <class N>
void interpolateByPlanes(StagedSamples<N> &run)
{
    for (const std::size_t channel : *run.carried)
        evaluate(run, run.setUp->plane[channel], run.value[channel].data());
    readValues(run);
}

template <class N>
void interpolateByWeights(StagedSamples<N> &run)
{
    using Number = typename N::Number;
    std::array<std::array<Number, StagedSamples<N>::capacity>, 3> weight;
    for (std::size_t i = 0; i < 3; ++i) {
        evaluate(run, run.setUp->weight[i], weight[i].data());
        for (std::size_t sample = 0; run.read && sample < run.size; ++sample)
            run.read[sample].weight[i] = weight[i][sample];
    }
    for (const std::size_t channel : *run.carried) {
        if (run.setUp->isCommon[channel]) { // the sum of rounded weights need not be 1
            const Number all = run.setUp->commonValue(channel);
            std::fill_n(run.value[channel].begin(), run.count,
                        N::isExact ? Number(all * run.setUp->area) : all);
            continue;
        }
        const auto &corner = run.setUp->vertices;
        const Number &first = corner[0].channels[channel];
        const Number &second = corner[1].channels[channel];
        const Number &third = corner[2].channels[channel];
        for (std::size_t i = 0; i < run.count; ++i)
            run.value[channel][i]
                = weight[0][i] * first + weight[1][i] * second + weight[2][i] * third;
    }
    readValues(run);
}

} // namespace pixelplumb::stages
