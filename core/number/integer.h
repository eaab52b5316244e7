// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pixelplumb {

/// 128-bit two's complement integer: wide enough for every exact product of lattice coordinates
/// (|coordinate| <= 2^38 units, doubled area <= 2^78, colour numerators < 2^88;
/// resources/numerics.md, 3.1 and 3.3).
__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 UInt128;

/// The quotient rounded towards minus infinity; the denominator must be positive.
template <class Integer>
constexpr Integer floorDivide(Integer numerator, Integer denominator)
{
    const Integer quotient = numerator / denominator;
    return quotient - Integer(numerator % denominator < 0);
}

/// The quotient rounded towards plus infinity; the denominator must be positive.
template <class Integer>
constexpr Integer ceilDivide(Integer numerator, Integer denominator)
{
    const Integer quotient = numerator / denominator;
    return quotient + Integer(numerator % denominator > 0);
}

template <class Integer>
constexpr Integer absolute(Integer value)
{
    return value < 0 ? -value : value;
}

constexpr Int128 greatestCommonDivisor(Int128 a, Int128 b)
{
    a = absolute(a);
    b = absolute(b);
    while (b != 0) {
        const Int128 remainder = a % b;
        a = b;
        b = remainder;
    }
    return a;
}

} // namespace pixelplumb
