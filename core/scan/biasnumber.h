// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/mixednumber.h"
#include "core/number/quantity.h"

#include <cmath>

namespace pixelplumb {

/// A number that float64 computes directly and whose rounding error is provably smaller than half
/// the distance β between the values that it can have: ⌈ŷ − β⌉ = ⌈y⌉ and ⌊ŷ + β⌋ = ⌊y⌋
/// (numerics.md, 3.2). Where that is not proved it is an integer quotient and remainder instead.
struct BiasNumber {
    bool isExact = false;
    double origin = 0;
    double run = 0; ///< steps from the origin, whole or not
    double rate = 0; ///< for each step
    double bias = 0; ///< β
    MixedNumber<Int128> exact;

    double value() const { return origin + run * rate; }

    std::int64_t floor() const
    {
        return isExact ? exact.floor() : std::int64_t(std::floor(value() + bias));
    }
    std::int64_t ceil() const
    {
        return isExact ? exact.ceil() : std::int64_t(std::ceil(value() - bias));
    }
};

inline Quantity quantityOf(const BiasNumber &number)
{
    return number.isExact ? Quantity::of(number.exact) : Quantity::of(number.value());
}
inline Quantity biasOf(const BiasNumber &number)
{
    return number.isExact ? Quantity::integer(0) : Quantity::of(number.bias);
}

template <class Number>
Quantity quantityOf(const Number &number)
{
    return Quantity::of(number);
}
/// Other numbers have no bias.
template <class Number>
Quantity biasOf(const Number &)
{
    return Quantity::integer(0);
}

} // namespace pixelplumb
