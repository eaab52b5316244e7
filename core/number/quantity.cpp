// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number/quantity.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace pixelplumb {

using LongDouble = long double;

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
    quantity.m_binary = double(value);
    return quantity;
}

Quantity Quantity::of(double value)
{
    Quantity quantity;
    quantity.m_kind = Kind::Float64;
    quantity.m_binary = value;
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
    const Int128 whole = floorDivide(m_numerator, m_denominator);
    const Int128 remainder = m_numerator - whole * m_denominator;
    return double(LongDouble(whole) + LongDouble(remainder) / LongDouble(m_denominator));
}

bool Quantity::isInteger() const
{
    if (isRational())
        return m_denominator == 1;
    return m_kind != Kind::None && std::isfinite(m_binary) && std::floor(m_binary) == m_binary;
}

double errorOf(const Quantity &used, const Quantity &exact)
{
    // Subtract the exact part's whole first: what is left is small, and long double holds it.
    const auto split = [](const Quantity &quantity) {
        const Int128 whole = floorDivide(quantity.numerator(), quantity.denominator());
        const Int128 remainder = quantity.numerator() - whole * quantity.denominator();
        return std::pair(whole, LongDouble(remainder) / LongDouble(quantity.denominator()));
    };
    if (used == exact)
        return 0;
    const auto [exactWhole, exactPart] = split(exact);
    if (used.isRational()) {
        const auto [usedWhole, usedPart] = split(used);
        return double(LongDouble(usedWhole - exactWhole) + (usedPart - exactPart));
    }
    return double((LongDouble(used.m_binary) - LongDouble(exactWhole)) - exactPart);
}

QString toText(Int128 value)
{
    if (value == 0)
        return QStringLiteral("0");
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

/// Sign, whole part towards zero, then the fraction: −2 1/3, not −3 2/3.
QString mixedText(Int128 numerator, Int128 denominator)
{
    const Int128 magnitude = absolute(numerator);
    const Int128 whole = magnitude / denominator;
    const Int128 remainder = magnitude % denominator;
    const QString sign = numerator < 0 ? QStringLiteral("-") : QString();
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
