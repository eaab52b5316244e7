// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

#include <optional>

namespace pixelplumb {

/// All that a number may be.
struct NumberRange {
    /// What long double itself rounds, relatively.
    static constexpr long double ownRounding = 0x1p-60L;

    long double least = 0;
    long double greatest = 0;

    bool isFinite() const;
};

/// Operations on ranges, each of which rounds as one of an arithmetic may.
class RangeArithmetic {
public:
    enum class Overflow { Never, Wraps }; ///< Wraps: of fixed-point numbers

    /// How far an operation's result may be from the true one, relatively or absolutely.
    struct RoundingStep {
        long double relative = 0;
        long double absolute = 0;
    };

    RangeArithmetic(Arithmetic arithmetic, Overflow overflow);

    /// Sums of whole numbers are not rounded, nor are any of fixed-point numbers; these wrap.
    NumberRange sum(const NumberRange &a, const NumberRange &b) const;
    NumberRange product(const NumberRange &a, const NumberRange &b) const;
    /// None of a divisor that is 0; anything where it may be.
    std::optional<NumberRange> quotient(const NumberRange &a, const NumberRange &b) const;
    /// Of numbers that are shown whole; none of a divisor that is 0.
    static std::optional<NumberRange> remainder(const NumberRange &a, const NumberRange &b);
    NumberRange root(const NumberRange &range) const;
    /// exponent >= 0; what is too small for the arithmetic may be 0.
    NumberRange power(const NumberRange &base, int exponent) const;
    /// A sine or cosine, whose slope is never more than 1.
    NumberRange turned(const NumberRange &angle, long double (*function)(long double)) const;
    /// A number that is read, which was rounded before it was shown.
    NumberRange shown(const NumberRange &seen) const;

private:
    /// Anything: what two numbers that are shown alike leave of their quotient.
    static NumberRange unknown();
    bool rounds() const { return m_step.relative > NumberRange::ownRounding; }
    /// Of fixed-point numbers that leave their range only the low bits are kept.
    NumberRange wrapped(const NumberRange &range) const;
    /// An operation's result, with what the arithmetic may have rounded.
    NumberRange rounded(const NumberRange &range) const;

    RoundingStep m_step;
    long double m_period = 0; ///< of fixed-point numbers that wrap; 0: they do not
};

} // namespace pixelplumb
