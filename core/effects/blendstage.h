// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/samplerun.h"

/// Alpha: the colour is mixed with what stands at its pixel.
namespace pixelplumb::stages {

template <class N>
void blend(SampleRun<N> &run)
{
    run.worked(EffectWork::Blend, run.count);
    const PixelArea *const area = run.surface->area;
    for (std::size_t i = 0; i < run.count; ++i) {
        const std::int64_t level = run.levelOf(Channel::Alpha, i);
        const auto alpha = std::uint8_t(clampedByte(level));
        const std::uint8_t share = area ? area->times(alpha) : alpha;
        run.colour[i] = blended(unpacked(run.colour[i]), run.pixelOf(i), share);
        if (run.read) {
            ShadedSample<N> &read = run.readOf(i);
            read.alphaLevel = level;
            read.alpha = alpha;
            read.blendedAlpha = share;
            read.area = area ? area->exact() : Quantity();
        }
    }
}

} // namespace pixelplumb::stages
