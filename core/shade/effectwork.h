// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// The costly work at a sample, which stages count.
enum class EffectWork : std::uint8_t {
    DepthRead,
    DepthWrite,
    Division, ///< by 1/w
    TexelFetch,
    Normal, ///< scaled to unit length
    Blend,
    Sample, ///< shaded for a pixel: its only one, or one of 4 or 16
};
inline constexpr std::size_t effectWorkCount = 7;

using EffectCounts = std::array<std::int64_t, effectWorkCount>;

/// How often the effects' work was done, and how much memory their buffers took.
struct EffectTally {
    EffectCounts done = {};
    std::size_t depthBytes = 0;

    std::int64_t operator[](EffectWork work) const { return done[std::size_t(work)]; }
    friend bool operator==(const EffectTally &, const EffectTally &) = default;
};

} // namespace pixelplumb
