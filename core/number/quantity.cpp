// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number/quantity.h"

#include "core/number/wideinteger.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pixelplumb {

namespace {

/// A fraction, not necessarily in lowest terms.
struct WideFraction {
    BigInteger numerator;
    BigInteger denominator; ///< > 0
};

/// The exact value of a finite quantity.
WideFraction exactlyOf(const Quantity &quantity)
{
    if (quantity.isRational())
        return {quantity.numerator(), quantity.denominator()};
    constexpr int bits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(quantity.toDouble(), &exponent), bits);
    exponent -= bits;
    return {BigInteger(std::int64_t(mantissa)) << std::max(exponent, 0),
            BigInteger(1) << std::max(-exponent, 0)};
}

/// The nearest double, rounded only once.
double nearestDouble(const WideFraction &fraction)
{
    if (fraction.numerator == 0)
        return 0;
    // Two or three bits more than a double has, with the last one standing for all that follow.
    const BigInteger size = abs(fraction.numerator);
    const int shift
        = std::numeric_limits<double>::digits + 2 + int(msb(fraction.denominator)) - int(msb(size));
    BigInteger quotient, remainder;
    divide_qr(BigInteger(size << std::max(shift, 0)),
              BigInteger(fraction.denominator << std::max(-shift, 0)), quotient, remainder);
    const auto bits = quotient.convert_to<std::uint64_t>() | std::uint64_t(remainder != 0);
    const double nearest = std::ldexp(double(bits), -shift);
    return fraction.numerator < 0 ? -nearest : nearest;
}

double withoutSignOfZero(double value) { return value == 0 ? 0 : value; }

} // namespace

Quantity Quantity::rational(Int128 numerator, Int128 denominator)
{
    Q_ASSERT(denominator > 0);
    const Int128 divisor = denominator == 1 ? 1 : greatestCommonDivisor(numerator, denominator);
    Quantity quantity;
    quantity.m_kind = Kind::Rational;
    quantity.m_numerator = numerator / divisor;
    quantity.m_denominator = denominator / divisor;
    return quantity;
}

Quantity Quantity::of(float value)
{
    Quantity quantity;
    quantity.m_kind = Kind::Float32;
    quantity.m_binary = withoutSignOfZero(double(value));
    return quantity;
}

Quantity Quantity::of(double value)
{
    Quantity quantity;
    quantity.m_kind = Kind::Float64;
    quantity.m_binary = withoutSignOfZero(value);
    return quantity;
}

bool Quantity::isFinite() const
{
    return m_kind == Kind::Rational || (m_kind != Kind::None && std::isfinite(m_binary));
}

double Quantity::toDouble() const
{
    if (!isRational())
        return m_binary;
    constexpr Int128 exactIntegers = Int128(1) << std::numeric_limits<double>::digits;
    if (absolute(m_numerator) <= exactIntegers && m_denominator <= exactIntegers)
        return double(m_numerator) / double(m_denominator);
    return nearestDouble(exactlyOf(*this));
}

bool Quantity::isInteger() const
{
    if (isRational())
        return m_denominator == 1;
    return m_kind != Kind::None && std::isfinite(m_binary) && std::floor(m_binary) == m_binary;
}

double errorOf(const Quantity &used, const Quantity &exact)
{
    if (used == exact)
        return 0;
    if (!used.isFinite())
        return used.toDouble();
    const WideFraction a = exactlyOf(used);
    const WideFraction b = exactlyOf(exact);
    return nearestDouble(
        {a.numerator * b.denominator - b.numerator * a.denominator, a.denominator * b.denominator});
}

Quantity productOf(const Quantity &a, const Quantity &b)
{
    constexpr Int128 largest = Int128(1) << 62;
    const auto fits = [](const Quantity &number) {
        return number.isRational() && absolute(number.numerator()) <= largest
            && number.denominator() <= largest;
    };
    return fits(a) && fits(b)
        ? Quantity::rational(a.numerator() * b.numerator(), a.denominator() * b.denominator())
        : Quantity::of(a.toDouble() * b.toDouble());
}

namespace {

/// toText() of floating point written without an exponent, padded with zeros; empty if it has more
/// places or an exponent.
QString filledDecimal(const Quantity &quantity, int places)
{
    QString text = quantity.isRational() ? QString() : toText(quantity);
    if (text.isEmpty() || text.contains(u'e'))
        return {};
    if (!text.contains(u'.'))
        text += u'.';
    const qsizetype missing = places - (text.size() - text.indexOf(u'.') - 1);
    return missing < 0 ? QString() : text + QString(missing, u'0');
}

} // namespace

CutDecimal cutDecimal(const Quantity &quantity, int places)
{
    constexpr int mostPlaces = 40; ///< the double next to 1 needs 16
    if (const QString whole = filledDecimal(quantity, places); !whole.isEmpty())
        return {whole, false};
    const auto [numerator, denominator] = exactlyOf(quantity);
    BigInteger whole, remainder;
    divide_qr(BigInteger(abs(numerator)), denominator, whole, remainder);
    CutDecimal decimal;
    if (numerator < 0)
        decimal.digits += u'-';
    decimal.digits += QString::fromStdString(whole.str()) + u'.';
    const bool isFraction = remainder != 0;
    bool isZero = true; // so far
    for (int place = 0; place < places || (isFraction && isZero && place < mostPlaces); ++place) {
        remainder *= 10;
        const BigInteger digit = remainder / denominator;
        remainder -= digit * denominator;
        isZero = isZero && digit == 0;
        decimal.digits += QChar(char16_t(u'0' + digit.convert_to<int>()));
    }
    decimal.isCut = remainder != 0;
    return decimal;
}

QString withMinus(QString text)
{
    const auto at = [&text](qsizetype place) { return place < 0 ? QChar() : text[place]; };
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        const bool isExponents = at(i - 1) == u'e' && at(i - 2).isDigit();
        const bool isSign = !at(i - 1).isLetterOrNumber() || isExponents;
        const bool hasNumber = text[i + 1].isDigit() || text.sliced(i + 1).startsWith(u"inf");
        if (text[i] == u'-' && isSign && hasNumber)
            text[i] = QChar(0x2212);
    }
    return text;
}

QString toText(Int128 value)
{
    if (value == 0)
        return u"0"_s;
    QString digits;
    const bool negative = value < 0;
    UInt128 rest = negative ? -UInt128(value) : UInt128(value);
    while (rest != 0) {
        digits.append(QChar(u'0' + char16_t(rest % 10)));
        rest /= 10;
    }
    if (negative)
        digits.append(u'-');
    std::reverse(digits.begin(), digits.end());
    return digits;
}

namespace {

template <class Float>
QString shortestDecimal(Float value)
{
    std::array<char, 64> text;
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    Q_ASSERT(error == std::errc());
    return QString::fromLatin1(text.data(), end - text.data());
}

/// Sign, then the whole part towards zero, then the fraction: −2 1/3, not −3 2/3.
QString mixedText(Int128 numerator, Int128 denominator)
{
    const Int128 magnitude = absolute(numerator);
    const Int128 whole = magnitude / denominator;
    const Int128 remainder = magnitude % denominator;
    const QString sign = numerator < 0 ? u"-"_s : QString();
    if (remainder == 0)
        return sign + toText(whole);
    const QString fraction = toText(remainder) + u'/' + toText(denominator);
    return whole == 0 ? sign + fraction : sign + toText(whole) + u' ' + fraction;
}

} // namespace

QString toText(const Quantity &quantity)
{
    switch (quantity.kind()) {
    case Quantity::Kind::None:
        return {};
    case Quantity::Kind::Rational:
        return mixedText(quantity.numerator(), quantity.denominator());
    case Quantity::Kind::Float32:
        return shortestDecimal(float(quantity.toDouble()));
    case Quantity::Kind::Float64:
        return shortestDecimal(quantity.toDouble());
    }
    return {};
}

QString toDecimal(const Quantity &quantity, int digits)
{
    if (quantity.isNone())
        return {};
    return QString::number(quantity.toDouble(), 'f', digits);
}

} // namespace pixelplumb
