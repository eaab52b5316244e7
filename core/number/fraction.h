// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"
#include "core/number/wideinteger.h"

#include <bit>
#include <memory>
#include <numeric>
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
            return floorOf(m_above, m_below);
        const BigInteger quotient = numerator(*m_wide) / denominator(*m_wide); // toward 0
        const bool isCutUpward
            = *m_wide < 0 && quotient * denominator(*m_wide) != numerator(*m_wide);
        return std::int64_t(quotient) - (isCutUpward ? 1 : 0);
    }
    std::int64_t ceil() const { return m_wide ? -(-*this).floor() : -floorOf(-m_above, m_below); }
    /// ⌊value + ½⌋
    std::int64_t nearest() const
    {
        constexpr Int128 most = Int128(1) << 124;
        const bool isShort = !m_wide && m_below < most && m_above < most && m_above > -most;
        return isShort ? floorOf(2 * m_above + m_below, 2 * m_below)
                       : (*this + Fraction(1, 2)).floor();
    }

    /// Over the same denominator, but for the twos that both have in common.
    friend void putOverOneDenominator(Fraction &a, Fraction &b)
    {
        const auto both = overOneDenominator(a, b);
        if (!both)
            return;
        const auto bits = UInt128(both->first.m_above) | UInt128(both->second.m_above)
            | UInt128(both->first.m_below);
        const int twos = std::countr_zero(std::uint64_t(bits) | std::uint64_t(1) << 63);
        a = Fraction(both->first.m_above >> twos, both->first.m_below >> twos);
        b = Fraction(both->second.m_above >> twos, both->second.m_below >> twos);
    }

    Fraction operator-() const
    {
        return m_wide ? Fraction(BigRational(-*m_wide)) : Fraction(-m_above, m_below);
    }
    friend Fraction operator+(const Fraction &a, const Fraction &b)
    {
        Fraction sum;
        if (!a.m_wide && !b.m_wide && sum.addUp(a, b, b.m_above))
            return sum;
        return combined(
            a, b,
            [](const Fraction &x, const Fraction &y, Fraction &result) {
                return result.addUp(x, y, y.m_above);
            },
            [](const BigRational &x, const BigRational &y) { return BigRational(x + y); });
    }
    friend Fraction operator-(const Fraction &a, const Fraction &b)
    {
        Fraction sum;
        if (!a.m_wide && !b.m_wide && sum.addUp(a, b, -b.m_above))
            return sum;
        return a + -b;
    }
    /// In place where both have one denominator, as the steps of a walk do.
    Fraction &operator+=(const Fraction &step)
    {
        Int128 above = 0;
        const bool isHeld = !m_wide && !step.m_wide && m_below == step.m_below
            && !__builtin_add_overflow(m_above, step.m_above, &above);
        if (isHeld)
            m_above = above;
        else
            *this = *this + step;
        return *this;
    }
    friend Fraction operator*(const Fraction &a, const Fraction &b)
    {
        Fraction product;
        if (!a.m_wide && !b.m_wide && product.multiply(a, b))
            return product;
        return combined(
            a, b,
            [](const Fraction &x, const Fraction &y, Fraction &result) {
                return result.multiply(x, y);
            },
            [](const BigRational &x, const BigRational &y) { return BigRational(x * y); });
    }
    /// b ≠ 0.
    friend Fraction operator/(const Fraction &a, const Fraction &b)
    {
        const bool isShared = !a.m_wide && !b.m_wide && a.m_below == b.m_below;
        return isShared ? Fraction(a.m_above, b.m_above) : a * b.inverse();
    }
    friend bool operator==(const Fraction &a, const Fraction &b) { return compared(a, b) == 0; }
    friend bool operator<(const Fraction &a, const Fraction &b) { return compared(a, b) < 0; }

    /// Both over one denominator; none where 128 bits do not hold them.
    friend std::optional<std::pair<Fraction, Fraction>> overOneDenominator(const Fraction &a,
                                                                           const Fraction &b)
    {
        if (a.m_wide || b.m_wide)
            return std::nullopt;
        const Factors factors = factorsOf(a.m_below, b.m_below);
        Int128 ofA = 0;
        Int128 ofB = 0;
        Int128 below = 0;
        const bool overflows = __builtin_mul_overflow(a.m_above, factors.ofA, &ofA)
            || __builtin_mul_overflow(b.m_above, factors.ofB, &ofB)
            || __builtin_mul_overflow(a.m_below, factors.ofA, &below);
        if (overflows)
            return std::nullopt;
        return std::pair(Fraction(ofA, below), Fraction(ofB, below));
    }

private:
    static bool is64(Int128 value) { return value == std::int64_t(value); }
    /// Most are short, and divided much faster as such.
    static std::int64_t floorOf(Int128 above, Int128 below)
    {
        if (is64(above) && is64(below))
            return floorDivide(std::int64_t(above), std::int64_t(below));
        const Int128 quotient = above / below;
        return std::int64_t(quotient) - (quotient * below > above ? 1 : 0);
    }
    /// a/b, if b divides a; else 0.
    static Int128 multipleOf(Int128 a, Int128 b)
    {
        if (is64(a)) {
            const auto quotient = std::int64_t(a) / std::int64_t(b);
            return quotient * std::int64_t(b) == std::int64_t(a) ? quotient : 0;
        }
        const Int128 quotient = a / b;
        return quotient * b == a ? quotient : 0;
    }

    /// What two denominators are multiplied by to be one.
    struct Factors {
        Int128 ofA, ofB;
    };
    /// One that is a multiple of the other, or short ones multiplied, are had without the greatest
    /// common divisor, which takes longer than all else.
    static Factors factorsOf(Int128 a, Int128 b)
    {
        constexpr Int128 shortest = Int128(1) << 12;
        constexpr Int128 half = Int128(1) << 31;
        if (a == b)
            return {1, 1};
        if (b == 1)
            return {1, a};
        if (a == 1)
            return {b, 1};
        if (const Int128 times = b < a ? multipleOf(a, b) : 0; times != 0)
            return {1, times};
        if (const Int128 times = a < b ? multipleOf(b, a) : 0; times != 0)
            return {times, 1};
        if (a < shortest || b < shortest || (a < half && b < half))
            return {b, a};
        const Int128 shared = is64(a) && is64(b)
            ? Int128(std::gcd(std::int64_t(a), std::int64_t(b)))
            : greatestCommonDivisor(a, b);
        return {b / shared, a / shared};
    }
    /// The sign of a − b: by the signs, or by products where 128 bits hold them.
    static int compared(const Fraction &a, const Fraction &b)
    {
        if (a.m_wide || b.m_wide)
            return signOf(a - b);
        Int128 ofA = a.m_above;
        Int128 ofB = b.m_above;
        const bool isTold = a.m_below == b.m_below || (ofA < 0) != (ofB < 0);
        const bool overflows = !isTold
            && (__builtin_mul_overflow(a.m_above, b.m_below, &ofA)
                || __builtin_mul_overflow(b.m_above, a.m_below, &ofB));
        return overflows ? signOf(a - b) : int(ofA > ofB) - int(ofA < ofB);
    }
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

    /// What 128 bits do not hold as it is: in lowest terms, or in wide integers.
    template <class Narrow, class InWide>
    [[gnu::noinline]] static Fraction combined(const Fraction &a, const Fraction &b,
                                               const Narrow &narrow, const InWide &inWide)
    {
        Fraction result;
        if (!a.m_wide && !b.m_wide && narrow(a.reduced(), b.reduced(), result))
            return result;
        return Fraction(inWide(a.wide(), b.wide()));
    }
    /// Becomes a plus aboveB over b's denominator; false where 128 bits do not hold it.
    bool addUp(const Fraction &a, const Fraction &b, Int128 aboveB)
    {
        if (a.m_below == b.m_below) {
            m_below = a.m_below;
            return !__builtin_add_overflow(a.m_above, aboveB, &m_above);
        }
        const Factors factors = factorsOf(a.m_below, b.m_below);
        Int128 first = 0;
        Int128 second = 0;
        return !(__builtin_mul_overflow(a.m_above, factors.ofA, &first)
                 || __builtin_mul_overflow(aboveB, factors.ofB, &second)
                 || __builtin_mul_overflow(a.m_below, factors.ofA, &m_below)
                 || __builtin_add_overflow(first, second, &m_above));
    }
    bool multiply(const Fraction &a, const Fraction &b)
    {
        return !(__builtin_mul_overflow(a.m_above, b.m_above, &m_above)
                 || __builtin_mul_overflow(a.m_below, b.m_below, &m_below));
    }

    Int128 m_above = 0;
    Int128 m_below = 1; ///< > 0
    std::shared_ptr<const BigRational> m_wide = {}; ///< in place of both
};

} // namespace pixelplumb
