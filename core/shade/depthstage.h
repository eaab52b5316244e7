// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shade/stagedsamples.h"

/// Depth: refuses a sample that lies behind the stored depth.
namespace pixelplumb::stages {

/// Depth in the kernel's own numbers: the values stored up a column, and those compared with them.
template <class N>
struct DepthNumbers {
    using Stored = typename N::Depth;

    static Stored *storedOf(const StagedSamples<N> &run)
    {
        return run.surface->depths->numbersAt(run.column->x, run.firstRow);
    }
    static Stored depthOf(const StagedSamples<N> &run, std::size_t sample)
    {
        const auto &value = run.valueOf(Channel::Depth, sample);
        if constexpr (N::isExact)
            return N::depth(value, run.setUp->area);
        else
            return value;
    }
    static void tell(DepthVerdict<N> &verdict, const Stored &before, const Stored &now)
    {
        verdict.before = before;
        verdict.now = now;
    }
};

/// Depth in levels.
template <class N>
struct DepthLevels {
    using Stored = std::uint32_t;

    static Stored *storedOf(const StagedSamples<N> &run)
    {
        return run.surface->depths->levelsAt(run.column->x, run.firstRow);
    }
    static Stored depthOf(const StagedSamples<N> &run, std::size_t sample)
    {
        const auto &value = run.valueOf(Channel::Depth, sample);
        const std::uint32_t greatest = run.surface->greatestLevel;
        if constexpr (N::isExact)
            return N::depthLevel(value, run.setUp->area, greatest);
        else
            return N::depthLevel(value, greatest);
    }
    static void tell(DepthVerdict<N> &verdict, Stored before, Stored now)
    {
        verdict.levelBefore = before;
        verdict.levelNow = now;
    }
};

template <class N, class Kind>
auto depthsOf(const StagedSamples<N> &run)
{
    std::array<typename Kind::Stored, StagedSamples<N>::capacity> depths;
    for (std::size_t i = 0; i < run.count; ++i)
        depths[i] = Kind::depthOf(run, i);
    return depths;
}

/// Stores depths that are not farther than the stored ones and marks their samples in `passes`;
/// returns how many. Only runs of one sample can have lost any before.
template <class N, class Kind>
std::size_t storeNearer(StagedSamples<N> &run,
                        std::array<std::uint32_t, StagedSamples<N>::capacity> &passes)
{
    const std::size_t count = run.count;
    auto *const stored = Kind::storedOf(run);
    const auto now = depthsOf<N, Kind>(run);
    for (std::size_t i = 0; run.read && i < count; ++i)
        Kind::tell(run.readOf(i).depth, stored[i], now[i]);
    std::uint32_t passing = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const bool isNearer = now[i] <= stored[i];
        stored[i] = isNearer ? now[i] : stored[i];
        passes[i] = isNearer ? 1 : 0;
        passing += passes[i];
    }
    run.worked(EffectWork::DepthRead, count);
    run.worked(EffectWork::DepthWrite, passing);
    return passing;
}

template <class N, class Kind>
void compareDepth(StagedSamples<N> &run)
{
    std::array<std::uint32_t, StagedSamples<N>::capacity> passes;
    const std::size_t passing = storeNearer<N, Kind>(run, passes);
    run.keep(passes, passing);
}

/// Depth test and flat paint: two stages in one, since nothing happens between them.
template <class N, class Kind>
void paintNearer(StagedSamples<N> &run)
{
    std::array<std::uint32_t, StagedSamples<N>::capacity> passes;
    const std::size_t passing = storeNearer<N, Kind>(run, passes);
    run.worked(EffectWork::Sample, passing);
    const QRgb flat = run.surface->flat;
    if (passing == run.count)
        run.forEachPixel([flat](QRgb &pixel, std::size_t) { pixel = flat; });
    else if (passing > 0) // branch-free, because the branch would often be mispredicted
        run.forEachPixel([&](QRgb &pixel, std::size_t i) { pixel = passes[i] ? flat : pixel; });
}

} // namespace pixelplumb::stages
