// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <random>

namespace pixelplumb {

/// Seeded random integers, the same on every machine: the standard's distributions differ between
/// libraries.
class SeededRandom {
public:
    explicit SeededRandom(std::uint64_t seed)
        : m_engine(seed)
    {
    }

    /// first … last, both included.
    std::int64_t between(std::int64_t first, std::int64_t last)
    {
        const auto count = std::uint64_t(last - first) + 1;
        return first + std::int64_t(m_engine() % count);
    }

    Colour colour()
    {
        Colour colour;
        for (std::uint8_t &channel : colour.channels)
            channel = std::uint8_t(between(0, 255));
        return colour;
    }

    bool coin() { return between(0, 1) != 0; }
    /// 0 <= value < 1, in steps of 2^-53.
    double unit() { return double(m_engine() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 m_engine;
};

} // namespace pixelplumb
