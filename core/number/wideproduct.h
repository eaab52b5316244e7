// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <compare>

namespace pixelplumb {

/// The product of two 128-bit numbers in 256 bits, for comparisons of what 128 bits cannot hold:
/// squares of products of lattice coordinates.
struct WideProduct {
    UInt128 high = 0;
    UInt128 low = 0;

    friend constexpr auto operator<=>(const WideProduct &, const WideProduct &) = default;
};

constexpr WideProduct wideProduct(UInt128 a, UInt128 b)
{
    constexpr UInt128 mask = ~std::uint64_t(0);
    const UInt128 lowLow = (a & mask) * (b & mask);
    const UInt128 lowHigh = (a & mask) * (b >> 64);
    const UInt128 highLow = (a >> 64) * (b & mask);
    const UInt128 highHigh = (a >> 64) * (b >> 64);
    // Three numbers below 2^64: no carry is lost.
    const UInt128 middle = (lowLow >> 64) + (lowHigh & mask) + (highLow & mask);
    return {highHigh + (lowHigh >> 64) + (highLow >> 64) + (middle >> 64),
            (middle << 64) | (lowLow & mask)};
}

/// The square of a number without its sign.
constexpr WideProduct wideSquare(Int128 number)
{
    const auto magnitude = UInt128(absolute(number));
    return wideProduct(magnitude, magnitude);
}

} // namespace pixelplumb
