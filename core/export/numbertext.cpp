// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/numbertext.h"

#include <QLocale>

#include <cmath>

namespace pixelplumb {

namespace {

constexpr Int128 largestDyadic = Int128(1) << 32;

bool endsInDecimals(Int128 denominator)
{
    return denominator <= largestDyadic && (denominator & (denominator - 1)) == 0;
}

/// All digits of a rational whose denominator is a power of two: the long division ends.
QString terminatingDecimal(Int128 numerator, Int128 denominator)
{
    const Int128 magnitude = absolute(numerator);
    QString text = numerator < 0 ? u"-"_s : QString();
    text += toText(magnitude / denominator);
    Int128 remainder = magnitude % denominator;
    if (remainder != 0)
        text += u'.';
    while (remainder != 0) {
        remainder *= 10;
        text += QChar(u'0' + char16_t(remainder / denominator));
        remainder %= denominator;
    }
    return text;
}

} // namespace

QString realText(double value)
{
    if (std::isnan(value))
        return u"nan"_s;
    if (std::isinf(value))
        return value < 0 ? u"-inf"_s : u"inf"_s;
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

QString decimalText(const Quantity &quantity)
{
    if (!quantity.isRational())
        return quantity.isNone() ? QString() : realText(quantity.toDouble());
    if (endsInDecimals(quantity.denominator()))
        return terminatingDecimal(quantity.numerator(), quantity.denominator());
    return realText(quantity.toDouble());
}

QString fractionText(const Quantity &quantity)
{
    if (!quantity.isRational() || quantity.isInteger())
        return decimalText(quantity);
    return toText(quantity.numerator()) + u'/' + toText(quantity.denominator());
}

} // namespace pixelplumb
