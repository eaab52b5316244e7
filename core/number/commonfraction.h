// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <compare>

namespace pixelplumb {

/// A fraction, not in lowest terms, that is only ever combined with integers and with fractions of
/// the same denominator, so adding needs no common multiple: all weights of a triangle have its
/// doubled area as denominator.
template <class Integer>
struct FractionOf {
    Integer numerator = 0;
    Integer denominator = 1; ///< > 0

    constexpr Integer floor() const { return floorDivide<Integer>(numerator, denominator); }
    /// The nearest integer; the upper one in a tie.
    constexpr Integer nearest() const
    {
        return floorDivide<Integer>(2 * numerator + denominator, 2 * denominator);
    }

    friend constexpr FractionOf operator+(FractionOf a, const FractionOf &b)
    {
        return {a.numerator + b.numerator, a.denominator};
    }
    friend constexpr FractionOf operator-(FractionOf a, const FractionOf &b)
    {
        return {a.numerator - b.numerator, a.denominator};
    }
    friend constexpr FractionOf operator-(int whole, const FractionOf &a)
    {
        return {whole * a.denominator - a.numerator, a.denominator};
    }
    friend constexpr FractionOf operator*(FractionOf a, int factor)
    {
        return {a.numerator * factor, a.denominator};
    }
    friend constexpr bool operator==(const FractionOf &a, int whole)
    {
        return a.numerator == whole * a.denominator;
    }
    friend constexpr auto operator<=>(const FractionOf &a, int whole)
    {
        return a.numerator <=> whole * a.denominator;
    }
};

using CommonFraction = FractionOf<Int128>;

} // namespace pixelplumb
