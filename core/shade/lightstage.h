// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// Light: what the scene's lights send from the sample to the viewer.
namespace pixelplumb::stages {

template <class N>
void light(StagedSamples<N> &run)
{
    run.worked(EffectWork::Normal, run.count);
    LitSample<typename N::Real> lit = {};
    for (std::size_t i = 0; i < run.count; ++i) {
        lit.place = run.vectorOf(Channel::PlaceX, Channel::PlaceY, Channel::PlaceZ, i);
        lightSample(*run.surface->lighting, *run.surface->material, unpacked(run.colour[i]),
                    run.vectorOf(Channel::NormalX, Channel::NormalY, Channel::NormalZ, i), lit);
        run.colour[i] = packed(lit.colour);
        if (run.read) {
            run.readOf(i).light = lit;
            run.readOf(i).source = lit.colour;
        }
    }
}

} // namespace pixelplumb::stages
