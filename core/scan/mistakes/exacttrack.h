// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/lattice.h"
#include "core/number/mixednumber.h"
#include "core/number/three.h"
#include "core/number/wideinteger.h"
#include "core/scan/mistakes/scanbugs.h"

namespace pixelplumb {

/// The part of a quotient that is kept; the denominator is positive.
template <class Integer>
Integer leftOf(const Integer &numerator, const Integer &denominator, Truncation kept)
{
    if (kept == Truncation::Nearest)
        return floorDivide<Integer>(2 * numerator + denominator, 2 * denominator);
    return kept == Truncation::Down ? floorDivide<Integer>(numerator, denominator)
                                    : Integer(numerator / denominator);
}

/// The fraction in lowest terms; one that 128 bits do not hold even so, to 2^−62.
template <class Integer>
MixedNumber<Int128> mixedNumber(Integer numerator, Integer denominator)
{
    Integer divisor = denominator;
    for (Integer rest = absolute(numerator) % divisor; rest != 0;) {
        const Integer next = divisor % rest;
        divisor = rest;
        rest = next;
    }
    numerator /= divisor;
    denominator /= divisor;
    if constexpr (!std::is_same_v<Integer, Int128>) {
        const Integer unit = Integer(1) << 62;
        if (denominator > unit * unit) {
            numerator = floorDivide<Integer>(numerator * unit, denominator);
            denominator = unit;
        }
    }
    return MixedNumber<Int128>::fromFraction(Int128(numerator), Int128(denominator));
}

/// A value that is stepped along an edge.
struct ExactTrack {
    Int128 at = 0, rate = 0;
    Int128 denominator = unitsPerPixel; ///< of both; > 0

    Int128 floor() const { return floorDivide<Int128>(at, denominator); }
    Int128 ceil() const { return ceilDivide<Int128>(at, denominator); }
    void store(Truncation kept)
    {
        if (kept != Truncation::All)
            at = leftOf<Int128>(at, denominator, kept) * denominator;
    }
    void step(Truncation kept)
    {
        at += rate;
        store(kept);
    }
    /// Continues from where another track has come to.
    void carryOn(const ExactTrack &other)
    {
        at = other.at * denominator;
        rate *= other.denominator;
        denominator *= other.denominator;
    }
};

} // namespace pixelplumb
