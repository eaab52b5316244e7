// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"
#include "core/space/materialcolour.h"

/// Texture: the colour is multiplied by the texels at u, v.
namespace pixelplumb::stages {

template <TextureFilter filter, class N>
void tintByTexels(StagedSamples<N> &run)
{
    run.worked(EffectWork::TexelFetch, run.count * texelsOf(filter));
    for (std::size_t i = 0; i < run.count; ++i) {
        const TexelSample<N> texels
            = fetchTexels<filter, N>(*run.surface->material, run.valueOf(Channel::U, i),
                                     run.valueOf(Channel::V, i), run.denominatorOf(i));
        const Colour colour = tinted(unpacked(run.colour[i]), texels.texel);
        run.colour[i] = packed(colour);
        if (run.read) {
            run.readOf(i).texels = texels;
            run.readOf(i).textured = run.readOf(i).source = colour;
        }
    }
}

} // namespace pixelplumb::stages
