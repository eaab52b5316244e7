// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <algorithm>
#include <array>
#include <cstdint>

namespace pixelplumb {

/// A level clamped to a byte, 0 … 255.
constexpr int clampedByte(std::int64_t level)
{
    return int(std::clamp<std::int64_t>(level, 0, 255));
}

/// The pixel of three levels R G B, each clamped. One test covers all three, because nearly every
/// level is already a byte. Force-inlined: a call would keep the kernel's innermost numbers in
/// memory.
[[gnu::always_inline]] inline constexpr QRgb pixelOfLevels(const std::array<std::int64_t, 3> &level)
{
    const auto [r, g, b] = level;
    if (std::uint64_t(r | g | b) <= 255) [[likely]]
        return QRgb(0xff000000U | unsigned(r) << 16U | unsigned(g) << 8U | unsigned(b));
    return qRgb(clampedByte(r), clampedByte(g), clampedByte(b));
}

} // namespace pixelplumb
