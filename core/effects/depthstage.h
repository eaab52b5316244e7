// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/samplerun.h"

/// Depth: a sample that lies behind what stands at its place is refused.
namespace pixelplumb::stages {

/// `stored` goes up the column from the run's first row; read(sample) is what is compared, and
/// tell(verdict, before, now) keeps it for who reads numbers. No longer run than of one sample has
/// lost any before.
template <class Stored, class N, class Read, class Tell>
void compareDepth(SampleRun<N> &run, Stored *stored, const Read &read, const Tell &tell)
{
    using Run = SampleRun<N>;
    typename Run::template PerSample<Stored> now;
    typename Run::template PerSample<std::uint32_t> passes;
    const std::size_t count = run.count;
    for (std::size_t i = 0; i < count; ++i)
        now[i] = read(i);
    for (std::size_t i = 0; run.read && i < count; ++i)
        tell(run.readOf(i).depth, stored[i], now[i]);
    std::uint32_t passing = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const bool isNearer = now[i] <= stored[i];
        stored[i] = isNearer ? now[i] : stored[i];
        passes[i] = isNearer ? 1 : 0;
        passing += passes[i];
    }
    run.worked(EffectWork::DepthRead, count);
    run.worked(EffectWork::DepthWrite, passing);
    run.keep(passes, passing);
}

template <class N>
void compareNumbers(SampleRun<N> &run)
{
    using Depth = typename N::Depth;
    compareDepth<Depth>(
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
    const std::uint32_t greatest = run.surface->greatestLevel;
    compareDepth<std::uint32_t>(
        run, run.surface->depths->levelsAt(run.column->x, run.firstRow),
        [&](std::size_t i) -> std::uint32_t {
            const auto &value = run.valueOf(Channel::Depth, i);
            if constexpr (N::isExact)
                return N::depthLevel(value, run.setUp->area, greatest);
            else
                return N::depthLevel(value, greatest);
        },
        [](DepthVerdict<N> &verdict, std::uint32_t before, std::uint32_t now) {
            verdict.levelBefore = before;
            verdict.levelNow = now;
        });
}

} // namespace pixelplumb::stages
