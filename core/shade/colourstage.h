// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// The vertex colours: one colour, or interpolated between three.
namespace pixelplumb::stages {

template <class N>
void readColours(const StagedSamples<N> &run)
{
    for (std::size_t i = 0; run.read && i < run.count; ++i) {
        ShadedSample<N> &read = run.readOf(i);
        read.interpolated = read.textured = read.source = unpacked(run.colour[i]);
    }
}

template <class N>
void setFlatColour(StagedSamples<N> &run)
{
    run.worked(EffectWork::Sample, run.count);
    std::fill_n(run.colour.begin(), run.count, run.surface->flat);
    for (std::size_t i = 0; run.read && i < run.count; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            run.readOf(i).level[channel] = unpacked(run.surface->flat).channels[channel];
    }
    readColours(run);
}

template <class N>
void setSmoothColour(StagedSamples<N> &run)
{
    run.worked(EffectWork::Sample, run.count);
    std::array<std::array<std::int64_t, StagedSamples<N>::capacity>, 3> levels;
    for (std::size_t channel = 0; channel < 3; ++channel)
        run.setLevels(channelAt(channel), levels[channel]);
    for (std::size_t i = 0; i < run.count; ++i)
        run.colour[i] = pixelOfLevels({levels[0][i], levels[1][i], levels[2][i]});
    for (std::size_t i = 0; run.read && i < run.count; ++i)
        run.readOf(i).level = {levels[0][i], levels[1][i], levels[2][i]};
    readColours(run);
}

} // namespace pixelplumb::stages
