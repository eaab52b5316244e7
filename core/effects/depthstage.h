// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/samplerun.h"

/// Depth: a sample that lies behind what stands at its place is refused.
namespace pixelplumb::stages {

/// `stored` goes up the column from the run's first row; read(sample) is what is compared, and
/// tell(verdict, before, now, passed) keeps it for who reads numbers.
template <class N, class Stored, class Read, class Tell>
void compareDepth(SampleRun<N> &run, Stored *stored, const Read &read, const Tell &tell)
{
    std::array<std::uint8_t, SampleRun<N>::capacity> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < run.count; ++i) {
        Stored &nearest = stored[run.row[i]];
        const Stored now = read(i);
        const bool passes = now <= nearest;
        if (run.read)
            tell(run.readOf(i).depth, nearest, now);
        if (passes)
            nearest = now;
        kept[count] = std::uint8_t(i);
        count += passes ? 1 : 0;
    }
    run.worked(EffectWork::DepthRead, run.count);
    run.worked(EffectWork::DepthWrite, count);
    run.keep(kept, count);
}

template <class N>
void compareNumbers(SampleRun<N> &run)
{
    using Depth = typename N::Depth;
    compareDepth(
        run, run.surface->depths->numbersAt(run.column->x, run.firstRow),
        [&](std::size_t i) -> Depth {
            const auto &value = run.valueOf(Channel::Depth, i);
            if constexpr (N::isExact)
                return N::depth(value, run.setUp->area);
            else
                return value;
        },
        [](DepthVerdict<N> &verdict, const Depth &before, const Depth &now) {
            verdict.before = before;
            verdict.now = now;
        });
}

template <class N>
void compareLevels(SampleRun<N> &run)
{
    compareDepth(
        run, run.surface->depths->levelsAt(run.column->x, run.firstRow),
        [&](std::size_t i) -> std::uint32_t {
            const auto &value = run.valueOf(Channel::Depth, i);
            if constexpr (N::isExact)
                return N::depthLevel(value, run.setUp->area, run.surface->greatestLevel);
            else
                return N::depthLevel(value, run.surface->greatestLevel);
        },
        [](DepthVerdict<N> &verdict, std::uint32_t before, std::uint32_t now) {
            verdict.levelBefore = before;
            verdict.levelNow = now;
        });
}

} // namespace pixelplumb::stages
