// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/commonfraction.h"
#include "core/number/fixedpoint.h"
#include "core/number/mixednumber.h"

#include <QString>

#include <optional>

namespace pixelplumb {

using namespace Qt::StringLiterals; // u"…"_s is a QString

/// A number as a kernel held it, in one form for tables, formulas and files: a rational (exact and
/// fixed-point arithmetic) or a binary floating-point value. Nothing is lost in the conversion but
/// the sign of a zero, which no formula uses.
class Quantity {
public:
    enum class Kind { None, Rational, Float32, Float64 };

    Quantity() = default;
    static Quantity integer(Int128 value) { return rational(value, 1); }
    /// numerator / denominator, brought to lowest terms; denominator > 0.
    static Quantity rational(Int128 numerator, Int128 denominator);
    static Quantity of(float value);
    static Quantity of(double value);
    static Quantity of(const CommonFraction &fraction)
    {
        return rational(fraction.numerator, fraction.denominator);
    }
    template <class Integer>
    static Quantity of(const MixedNumber<Integer> &number)
    {
        return rational(Int128(number.whole) * number.denominator + number.remainder,
                        number.denominator);
    }
    template <class Raw, class Product, int FractionBits>
    static Quantity of(FixedPoint<Raw, Product, FractionBits> number)
    {
        return rational(number.raw(), Int128(1) << FractionBits);
    }

    Kind kind() const { return m_kind; }
    bool isNone() const { return m_kind == Kind::None; }
    bool isRational() const { return m_kind == Kind::Rational; }
    bool isFinite() const;
    Int128 numerator() const { return m_numerator; } ///< of a rational
    Int128 denominator() const { return m_denominator; } ///< of a rational, > 0

    /// The nearest double; for drawing, plots and files, never for a decision.
    double toDouble() const;
    /// Whether it is exactly an integer: 17, but not 17.0000001.
    bool isInteger() const;

    friend bool operator==(const Quantity &, const Quantity &) = default;

private:
    Kind m_kind = Kind::None;
    Int128 m_numerator = 0;
    Int128 m_denominator = 1;
    double m_binary = 0;
};

/// used − exact as the nearest double: 0 if and only if they are equal.
double errorOf(const Quantity &used, const Quantity &exact);

/// a · b: exact where both are rational with numerators and denominators up to 2^62, else in
/// double. Neither may be none.
Quantity productOf(const Quantity &a, const Quantity &b);

/// The one spelling of a quantity in tables, files and on the command line: rationals as "17 3/8",
/// floating point as the shortest decimal that reads back as the same value, none as "".
QString toText(const Quantity &quantity);

/// The quantity in decimals with a fixed number of digits after the point ("17.375000"), for
/// columns of figures; C locale.
QString toDecimal(const Quantity &quantity, int digits);

/// The digits of a decimal, and whether more follow.
struct CutDecimal {
    QString digits; ///< "-2.33"
    bool isCut = false; ///< digits other than 0 follow
};

/// The decimal of a finite number, cut, not rounded, after `places` digits; for floating point,
/// that of toText() if it ends within them. If those digits are all 0 and the number is not whole,
/// it continues to the first other digit, so that a number whose ceiling is 13 is not shown as 12.
CutDecimal cutDecimal(const Quantity &quantity, int places);

/// A text for people: its negative numbers and exponents get minus signs instead of hyphens.
QString withMinus(QString text);

/// A 128-bit integer in decimal.
QString toText(Int128 value);

} // namespace pixelplumb
