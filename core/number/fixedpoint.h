// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <compare>
#include <type_traits>

namespace pixelplumb {

/// Binary fixed point: value = raw / 2^FractionBits. Products and quotients are rounded to nearest
/// (halves up), sums are exact, and whatever leaves the range wraps modulo 2^bits, as in the
/// integer registers of the machines that this arithmetic comes from. No operation is undefined.
template <class Raw, class Product, int FractionBits>
class FixedPoint {
public:
    using RawType = Raw;
    static constexpr int fractionBits = FractionBits;
    static constexpr Product one = Product(1) << FractionBits;

    constexpr FixedPoint() = default;

    static constexpr FixedPoint fromRaw(Raw raw)
    {
        FixedPoint number;
        number.m_raw = raw;
        return number;
    }
    static constexpr FixedPoint fromInteger(std::int64_t integer)
    {
        return fromRaw(wrapped(Product(integer) * one));
    }
    /// numerator / denominator; the denominator is a power of two that divides 2^FractionBits.
    static constexpr FixedPoint fromBinaryFraction(std::int64_t numerator, std::int64_t denominator)
    {
        return fromRaw(wrapped(Product(numerator) * (one / denominator)));
    }

    constexpr Raw raw() const { return m_raw; }
    constexpr std::int64_t floor() const { return std::int64_t(m_raw >> FractionBits); }
    constexpr std::int64_t ceil() const
    {
        return std::int64_t((Product(m_raw) + one - 1) >> FractionBits);
    }

    friend constexpr FixedPoint operator+(FixedPoint a, FixedPoint b)
    {
        return fromRaw(wrapped(Product(a.m_raw) + b.m_raw));
    }
    friend constexpr FixedPoint operator-(FixedPoint a, FixedPoint b)
    {
        return fromRaw(wrapped(Product(a.m_raw) - b.m_raw));
    }
    friend constexpr FixedPoint operator*(FixedPoint a, FixedPoint b)
    {
        return fromRaw(wrapped((Product(a.m_raw) * b.m_raw + one / 2) >> FractionBits));
    }
    /// The divisor must not be zero.
    friend constexpr FixedPoint operator/(FixedPoint a, FixedPoint b)
    {
        const Product sign = b.m_raw < 0 ? -1 : 1;
        const Product numerator = Product(a.m_raw) * one * sign;
        const Product denominator = Product(b.m_raw) * sign;
        return fromRaw(wrapped(floorDivide<Product>(2 * numerator + denominator, 2 * denominator)));
    }
    friend constexpr auto operator<=>(FixedPoint, FixedPoint) = default;

private:
    /// Modulo 2^bits, in the unsigned type, where wrapping is defined.
    static constexpr Raw wrapped(Product value) { return Raw(std::make_unsigned_t<Raw>(value)); }

    Raw m_raw = 0;
};

using FixedPoint16 = FixedPoint<std::int32_t, std::int64_t, 16>;
using FixedPoint32 = FixedPoint<std::int64_t, Int128, 32>;

} // namespace pixelplumb
