// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>

namespace pixelplumb {

/// Larger than every frame, coordinate and level, and safe to convert.
inline constexpr std::int64_t largestWhole = std::int64_t(1) << 40;

/// ⌊value⌋, clamped to ±2^40; the lower limit for NaN. Compiling for every x86-64 turns std::floor
/// into a call, which costs more than the pixel it serves.
template <std::floating_point Float>
constexpr std::int64_t floorOf(Float value)
{
    constexpr auto limit = Float(largestWhole);
    if (value >= Float(0) && value < limit) [[likely]]
        return std::int64_t(value);
    if (!(value > -limit))
        return -largestWhole;
    if (!(value < limit))
        return largestWhole;
    const auto towardsZero = std::int64_t(value);
    return towardsZero - std::int64_t(Float(towardsZero) > value);
}

/// ⌈value⌉, with the same limits.
template <std::floating_point Float>
constexpr std::int64_t ceilOf(Float value)
{
    constexpr auto limit = Float(largestWhole);
    if (value > -limit && value < limit) [[likely]] {
        const auto towardsZero = std::int64_t(value);
        return towardsZero + std::int64_t(Float(towardsZero) < value);
    }
    return value >= limit ? largestWhole : -largestWhole;
}

} // namespace pixelplumb
