// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/mixednumber.h"
#include "core/number/quantity.h"
#include "core/number/wholenumber.h"

namespace pixelplumb {

/// A number that float64 computes directly and whose rounding error is provably smaller than half
/// the distance β between the values that it can have: ⌈ŷ − β⌉ = ⌈y⌉ and ⌊ŷ + β⌋ = ⌊y⌋
/// (resources/numerics.md, 3.2).
struct BiasNumber {
    double origin = 0;
    double run = 0; ///< steps from the origin, whole or not
    double rate = 0; ///< for each step
    double bias = 0; ///< β

    double value() const { return origin + run * rate; }

    std::int64_t floor() const { return floorOf(value() + bias); }
    std::int64_t ceil() const { return ceilOf(value() - bias); }
    void advance(const BiasNumber &) { run += 1; }
};

inline Quantity quantityOf(const BiasNumber &number) { return Quantity::of(number.value()); }
inline Quantity biasOf(const BiasNumber &number) { return Quantity::of(number.bias); }

/// A BiasNumber, or an integer quotient and remainder where the bias is not proved.
struct BiasOrExactNumber {
    bool isExact = false;
    BiasNumber biased;
    MixedNumber<Int128> exact;

    BiasOrExactNumber() = default;
    BiasOrExactNumber(const BiasNumber &number)
        : biased(number)
    {
    }
    BiasOrExactNumber(const MixedNumber<Int128> &number)
        : isExact(true)
        , exact(number)
    {
    }

    std::int64_t floor() const { return isExact ? exact.floor() : biased.floor(); }
    std::int64_t ceil() const { return isExact ? exact.ceil() : biased.ceil(); }
    void advance(const BiasOrExactNumber &rate)
    {
        if (isExact)
            exact.advance(rate.exact);
        else
            biased.advance(rate.biased);
    }
};

inline Quantity quantityOf(const BiasOrExactNumber &number)
{
    return number.isExact ? Quantity::of(number.exact) : quantityOf(number.biased);
}
inline Quantity biasOf(const BiasOrExactNumber &number)
{
    return number.isExact ? Quantity::integer(0) : biasOf(number.biased);
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
