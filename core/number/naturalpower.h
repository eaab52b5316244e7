// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// base^exponent by squaring, exponent >= 0; every standard library gives the same result.
template <class Number>
Number naturalPower(Number base, int exponent)
{
    Number power(1);
    for (; exponent > 0; exponent /= 2) {
        if (exponent % 2 == 1)
            power *= base;
        base *= base;
    }
    return power;
}

} // namespace pixelplumb
