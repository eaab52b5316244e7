// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <optional>

namespace pixelplumb {

/// The range of values a number may have.
struct NumberRange {
    /// The relative rounding error of long double itself.
    static constexpr long double ownRounding = 0x1p-60L;

    long double least = 0;
    long double greatest = 0;

    bool isFinite() const;
};

/// Operations on ranges; each one rounds as the arithmetic may.
class RangeArithmetic {
public:
    enum class Overflow { Never, Wraps }; ///< Wraps: for fixed-point numbers

    /// The largest error of an operation's result, relative or absolute.
    struct RoundingStep {
        long double relative = 0;
        long double absolute = 0;
    };

    RangeArithmetic(Arithmetic arithmetic, Overflow overflow);

    /// Sums of whole numbers are not rounded, nor are sums of fixed-point numbers; the latter wrap.
    NumberRange sum(const NumberRange &a, const NumberRange &b) const;
    NumberRange product(const NumberRange &a, const NumberRange &b) const;
    /// None if the divisor is 0; any value if it may be 0.
    std::optional<NumberRange> quotient(const NumberRange &a, const NumberRange &b) const;
    /// For numbers that are shown whole; none if the divisor is 0.
    static std::optional<NumberRange> remainder(const NumberRange &a, const NumberRange &b);
    NumberRange root(const NumberRange &range) const;
    /// exponent >= 0; a result too small for the arithmetic may be 0.
    NumberRange power(const NumberRange &base, int exponent) const;
    /// A sine or cosine; the slope of either is at most 1.
    NumberRange turned(const NumberRange &angle, long double (*function)(long double)) const;
    /// The range of a number that was rounded before it was shown.
    NumberRange shown(const NumberRange &seen) const;

private:
    /// The unbounded range: for instance the quotient by a difference of two numbers that look
    /// alike.
    static NumberRange unknown();
    bool rounds() const { return m_step.relative > NumberRange::ownRounding; }
    /// Keeps only the low bits of fixed-point numbers that leave their range.
    NumberRange wrapped(const NumberRange &range) const;
    /// An operation's result, widened by the arithmetic's rounding.
    NumberRange rounded(const NumberRange &range) const;

    RoundingStep m_step;
    long double m_period = 0; ///< the wrapping period of fixed-point numbers; 0 if they do not wrap
};

} // namespace pixelplumb
