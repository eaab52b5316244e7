// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// Alpha blending: mixes the colour with the pixel's current one.
namespace pixelplumb::stages {

template <class N>
void blend(StagedSamples<N> &run)
{
    run.worked(EffectWork::Blend, run.count);
    std::array<std::int64_t, StagedSamples<N>::capacity> levels;
    std::array<std::uint8_t, StagedSamples<N>::capacity> share;
    run.setLevels(Channel::Alpha, levels);
    for (std::size_t i = 0; i < run.count; ++i)
        share[i] = std::uint8_t(clampedByte(levels[i]));
    const PixelArea *const area = run.surface->area;
    for (std::size_t i = 0; area && i < run.count; ++i)
        share[i] = area->times(share[i]);
    run.forEachPixel([&](QRgb under, std::size_t i) {
        run.colour[i] = blended(unpacked(run.colour[i]), under, share[i]);
    });
    for (std::size_t i = 0; run.read && i < run.count; ++i) {
        ShadedSample<N> &read = run.readOf(i);
        read.alphaLevel = levels[i];
        read.alpha = std::uint8_t(clampedByte(levels[i]));
        read.blendedAlpha = share[i];
        read.area = area ? area->exact() : Quantity();
    }
}

} // namespace pixelplumb::stages
