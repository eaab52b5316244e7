// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/companiontypes.h"

namespace pixelplumb {

/// An exact rational as a student writes it: whole + remainder / denominator, 17 3/8.
/// Invariant: 0 <= remainder < denominator. Adding a rate of the same denominator needs no
/// division: add the wholes, add the remainders, carry at most once (resources/numerics.md, 3.1,
/// proof).
template <class Integer>
struct MixedNumber {
    using Whole = NarrowBeside<Integer>;

    Whole whole = 0;
    Integer remainder = 0;
    Integer denominator = 1;

    /// numerator / denominator by floor division; denominator > 0, quotient within int64.
    [[gnu::always_inline]] static constexpr MixedNumber fromFraction(Integer numerator,
                                                                     Integer denominator)
    {
        const Integer whole = floorDivide(numerator, denominator);
        return {Whole(whole), numerator - whole * denominator, denominator};
    }

    static constexpr MixedNumber fromWhole(std::int64_t whole) { return {whole, 0, 1}; }

    /// Adds a rate with the same denominator as this number.
    constexpr void advance(const MixedNumber &rate)
    {
        whole += rate.whole;
        remainder += rate.remainder;
        if (remainder >= denominator) {
            remainder -= denominator;
            ++whole;
        }
    }

    constexpr std::int64_t floor() const { return std::int64_t(whole); }
    constexpr std::int64_t ceil() const { return std::int64_t(whole + Whole(remainder != 0)); }

    friend constexpr bool operator==(const MixedNumber &, const MixedNumber &) = default;
};

} // namespace pixelplumb
