// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"
#include "core/number/wideinteger.h"

#include <memory>
#include <optional>
#include <utility>

namespace pixelplumb {

/// An exact fraction of any size: in 128 bits, and reduced only when those run out, since most are
/// read before that; in wide integers where even lowest terms do not fit.
class Fraction {
public:
    constexpr Fraction(std::int64_t whole = 0)
        : m_above(whole)
    {
    }
    /// below ≠ 0.
    Fraction(Int128 above, Int128 below)
        : m_above(below < 0 ? -above : above)
        , m_below(below < 0 ? -below : below)
    {
    }
    explicit Fraction(const BigRational &value)
    {
        static const BigInteger most = (BigInteger(1) << 126) - 1;
        if (abs(numerator(value)) <= most && denominator(value) <= most) {
            m_above = Int128(numerator(value));
            m_below = Int128(denominator(value));
        } else {
            m_wide = std::make_shared<const BigRational>(value);
        }
    }

    bool isNarrow() const { return !m_wide; }
    /// Of a narrow one, not in lowest terms.
    Int128 above() const { return m_above; }
    Int128 below() const { return m_below; } ///< > 0
    BigRational wide() const
    {
        return m_wide ? *m_wide : BigRational(BigInteger(m_above), BigInteger(m_below));
    }
    std::int64_t floor() const
    {
        if (!m_wide)
            return std::int64_t(floorDivide(m_above, m_below));
        const BigInteger quotient = numerator(*m_wide) / denominator(*m_wide); // toward 0
        const bool isCutUpward
            = *m_wide < 0 && quotient * denominator(*m_wide) != numerator(*m_wide);
        return std::int64_t(quotient) - (isCutUpward ? 1 : 0);
    }
    std::int64_t ceil() const { return -(-*this).floor(); }

    Fraction operator-() const
    {
        return m_wide ? Fraction(BigRational(-*m_wide)) : Fraction(-m_above, m_below);
    }
    friend Fraction operator+(const Fraction &a, const Fraction &b)
    {
        return combined(a, b, narrowSum, [](const BigRational &x, const BigRational &y) {
            return BigRational(x + y);
        });
    }
    friend Fraction operator-(const Fraction &a, const Fraction &b) { return a + -b; }
    friend Fraction operator*(const Fraction &a, const Fraction &b)
    {
        return combined(a, b, narrowProduct, [](const BigRational &x, const BigRational &y) {
            return BigRational(x * y);
        });
    }
    /// b ≠ 0.
    friend Fraction operator/(const Fraction &a, const Fraction &b) { return a * b.inverse(); }
    friend bool operator==(const Fraction &a, const Fraction &b) { return signOf(a - b) == 0; }
    friend bool operator<(const Fraction &a, const Fraction &b) { return signOf(a - b) < 0; }

    /// Both over one denominator; none where 128 bits do not hold them.
    friend std::optional<std::pair<Fraction, Fraction>> overOneDenominator(const Fraction &a,
                                                                           const Fraction &b)
    {
        const Fraction sum = a + b;
        Int128 ofA = 0;
        Int128 ofB = 0;
        const bool isHeld = sum.isNarrow() && a.isNarrow() && b.isNarrow()
            && sum.m_below % a.m_below == 0 && sum.m_below % b.m_below == 0
            && !__builtin_mul_overflow(a.m_above, sum.m_below / a.m_below, &ofA)
            && !__builtin_mul_overflow(b.m_above, sum.m_below / b.m_below, &ofB);
        if (!isHeld)
            return std::nullopt;
        return std::pair(Fraction(ofA, sum.m_below), Fraction(ofB, sum.m_below));
    }

private:
    using Narrow = std::optional<Fraction>;

    static int signOf(const Fraction &value)
    {
        if (value.m_wide)
            return value.m_wide->sign();
        return int(value.m_above > 0) - int(value.m_above < 0);
    }
    Fraction inverse() const
    {
        return m_wide ? Fraction(BigRational(1 / *m_wide)) : Fraction(m_below, m_above);
    }
    Fraction reduced() const
    {
        const Int128 divisor = greatestCommonDivisor(m_above, m_below);
        return {m_above / divisor, m_below / divisor};
    }

    template <class InWide>
    static Fraction combined(const Fraction &a, const Fraction &b,
                             Narrow (*narrow)(const Fraction &a, const Fraction &b),
                             const InWide &inWide)
    {
        if (!a.m_wide && !b.m_wide) {
            if (const Narrow found = narrow(a, b))
                return *found;
            if (const Narrow found = narrow(a.reduced(), b.reduced()))
                return *found;
        }
        return Fraction(inWide(a.wide(), b.wide()));
    }
    /// None where 128 bits do not hold it.
    static Narrow checked(bool overflows, Int128 above, Int128 below)
    {
        return overflows ? Narrow() : Narrow(std::in_place, above, below);
    }
    static Narrow narrowSum(const Fraction &a, const Fraction &b)
    {
        Int128 above = 0;
        if (a.m_below == b.m_below) {
            const bool overflows = __builtin_add_overflow(a.m_above, b.m_above, &above);
            return checked(overflows, above, a.m_below);
        }
        // Over the least common denominator: sums of one walk's numbers stay short.
        const Int128 shared = a.m_below == 1 || b.m_below == 1
            ? Int128(1)
            : greatestCommonDivisor(a.m_below, b.m_below);
        const Int128 ofA = b.m_below / shared;
        const Int128 ofB = a.m_below / shared;
        Int128 first = 0;
        Int128 second = 0;
        Int128 below = 0;
        const bool overflows = __builtin_mul_overflow(a.m_above, ofA, &first)
            | __builtin_mul_overflow(b.m_above, ofB, &second)
            | __builtin_mul_overflow(a.m_below, ofA, &below)
            | __builtin_add_overflow(first, second, &above);
        return checked(overflows, above, below);
    }
    static Narrow narrowProduct(const Fraction &a, const Fraction &b)
    {
        Int128 above = 0;
        Int128 below = 0;
        const bool overflows = __builtin_mul_overflow(a.m_above, b.m_above, &above)
            | __builtin_mul_overflow(a.m_below, b.m_below, &below);
        return checked(overflows, above, below);
    }

    Int128 m_above = 0;
    Int128 m_below = 1; ///< > 0
    std::shared_ptr<const BigRational> m_wide = {}; ///< in place of both
};

} // namespace pixelplumb
