// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// Perspective: divides what was interpolated over w by 1/w.
namespace pixelplumb::stages {

/// Refuses samples beyond the horizon of the triangle's plane, which have no attributes. Only areas
/// extend so far.
template <class N>
void leaveHorizon(StagedSamples<N> &run)
{
    std::array<std::uint32_t, StagedSamples<N>::capacity> passes;
    std::size_t passing = 0;
    for (std::size_t i = 0; i < run.count; ++i) {
        passes[i] = run.valueOf(Channel::Reciprocal, i) > 0 ? 1 : 0;
        passing += passes[i];
    }
    run.keep(passes, passing);
}

/// Divides floating numbers; exact numerators get another denominator instead.
template <class N>
void divideByW(StagedSamples<N> &run)
{
    run.worked(EffectWork::Division, run.count);
    const auto &reciprocal = run.value[indexOf(Channel::Reciprocal)];
    if constexpr (N::isExact) {
        run.denominator = reciprocal.data();
        run.isDivided = true;
    } else {
        for (const std::size_t channel : *run.carried) {
            if (!followsPerspective(channelAt(channel)) || run.setUp->isCommon[channel])
                continue;
            for (std::size_t i = 0; i < run.count; ++i)
                run.value[channel][i] = run.value[channel][i] / reciprocal[i];
        }
    }
}

} // namespace pixelplumb::stages
