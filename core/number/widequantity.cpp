// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number/widequantity.h"

namespace pixelplumb {

Quantity quotientOf(const BigInteger &numerator, const BigInteger &denominator)
{
    constexpr unsigned mostBits = 126;
    const BigRational lowest(numerator, denominator);
    const BigInteger above = boost::multiprecision::numerator(lowest);
    const BigInteger below = boost::multiprecision::denominator(lowest);
    if (msb(abs(above) | below) >= mostBits)
        return Quantity::of(lowest.convert_to<double>());
    return Quantity::rational(above.convert_to<Int128>(), below.convert_to<Int128>());
}

} // namespace pixelplumb
