// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pixelplumb {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers with every compiler and library, which
/// the distributions of <random> do not guarantee.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed)
        : m_state(seed)
    {
    }

    std::uint64_t next()
    {
        m_state += 0x9e3779b97f4a7c15U;
        std::uint64_t bits = m_state;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
        return bits ^ (bits >> 31);
    }
    /// A number in [first, last]; the bias of the remainder does not matter here.
    std::int64_t in(std::int64_t first, std::int64_t last)
    {
        const auto count = std::uint64_t(last - first) + 1;
        return first + std::int64_t(next() % count);
    }
    bool oneIn(int count) { return in(1, count) == 1; }

private:
    std::uint64_t m_state;
};

} // namespace pixelplumb
