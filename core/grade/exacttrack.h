// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/programwalk.h"
#include "core/number/wideinteger.h"

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
