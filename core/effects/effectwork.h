// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// What is done at a sample that costs something: what stages count.
enum class EffectWork : std::uint8_t {
    DepthRead,
    DepthWrite,
    Division, ///< by 1/w
    TexelFetch,
    Normal, ///< made unit length
    Blend,
    Sample, ///< that gives a pixel: one, or one of 4 or 16
};
inline constexpr std::size_t effectWorkCount = 7;

using EffectCounts = std::array<std::int64_t, effectWorkCount>;

/// How often the work of effects was done, and what memory their buffers took.
struct EffectTally {
    EffectCounts done = {};
    std::size_t depthBytes = 0;

    std::int64_t operator[](EffectWork work) const { return done[std::size_t(work)]; }
    friend bool operator==(const EffectTally &, const EffectTally &) = default;
};

} // namespace pixelplumb
