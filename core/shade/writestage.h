// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// The last stage: colours become pixels.
namespace pixelplumb::stages {

template <class N>
void write(StagedSamples<N> &run)
{
    run.forEachPixel([&](QRgb &pixel, std::size_t i) { pixel = run.colour[i]; });
}

/// Paints the triangle's one colour, which no stage has changed: two stages in one, since there is
/// little else to do for such samples.
template <class N>
void paint(StagedSamples<N> &run)
{
    run.worked(EffectWork::Sample, run.count);
    run.forEachPixel([flat = run.surface->flat](QRgb &pixel, std::size_t) { pixel = flat; });
}

} // namespace pixelplumb::stages
