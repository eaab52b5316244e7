// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/numberformat.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr QChar minusSign(0x2212);
constexpr QChar ellipsis(0x2026);
constexpr QChar narrowSpace(0x202f); // does not break
constexpr Int128 largestShownDenominator = 999999;
constexpr int defaultPlaces = 6;
// Enough to tell neighbours apart: 2^-16 > 10^-5, 2^-32 > 10^-10.
constexpr int fixed16Places = 6;
constexpr int fixed32Places = 11;

QLocale groupingLocale()
{
    QLocale locale = QLocale::c();
    locale.setNumberOptions({});
    return locale;
}

QString nonFiniteText(double value)
{
    if (std::isnan(value))
        return u"NaN"_s;
    return value < 0 ? u"−∞"_s : u"∞"_s;
}

/// The fewest digits that read back as the same value; plain notation from 10^-9 to below 10^15.
template <class Float>
QString shortestDecimal(Float value)
{
    const auto magnitude = std::abs(double(value));
    const bool plain = magnitude == 0 || (magnitude >= 1e-9 && magnitude < 1e15);
    std::array<char, 64> text;
    const auto result
        = std::to_chars(text.data(), text.data() + text.size(), value,
                        plain ? std::chars_format::fixed : std::chars_format::scientific);
    return withMinus(QString::fromLatin1(text.data(), result.ptr - text.data()));
}

QString mixedNumber(const Quantity &quantity)
{
    const Int128 magnitude = absolute(quantity.numerator());
    const Int128 whole = magnitude / quantity.denominator();
    const Int128 remainder = magnitude % quantity.denominator();
    QString text;
    if (quantity.numerator() < 0)
        text += minusSign;
    if (whole != 0 || remainder == 0)
        text += toText(whole);
    if (remainder != 0) {
        if (whole != 0)
            text += thinSpace;
        text += toText(remainder) + u'/' + toText(quantity.denominator());
    }
    return text;
}

QString cutText(const Quantity &quantity, int places)
{
    const auto [digits, isCut] = cutDecimal(quantity, places);
    return withMinus(isCut ? digits + ellipsis : digits);
}

} // namespace

QString displayText(const Quantity &quantity)
{
    switch (quantity.kind()) {
    case Quantity::Kind::None:
        return {};
    case Quantity::Kind::Rational:
        return quantity.denominator() <= largestShownDenominator ? mixedNumber(quantity)
                                                                 : displayDecimal(quantity);
    case Quantity::Kind::Float32:
    case Quantity::Kind::Float64:
        break;
    }
    if (!quantity.isFinite())
        return nonFiniteText(quantity.toDouble());
    return quantity.kind() == Quantity::Kind::Float32 ? shortestDecimal(float(quantity.toDouble()))
                                                      : shortestDecimal(quantity.toDouble());
}

QString displayText(const Quantity &quantity, Arithmetic arithmetic)
{
    if (!quantity.isRational() || quantity.isInteger())
        return displayText(quantity);
    if (arithmetic == Arithmetic::Fixed16)
        return displayDecimal(quantity, fixed16Places);
    if (arithmetic == Arithmetic::Fixed32)
        return displayDecimal(quantity, fixed32Places);
    return displayText(quantity);
}

QString displayDecimal(const Quantity &quantity) { return displayDecimal(quantity, defaultPlaces); }

QString displayDecimal(const Quantity &quantity, int places)
{
    if (quantity.isNone())
        return {};
    if (!quantity.isFinite())
        return nonFiniteText(quantity.toDouble());
    return cutText(quantity, places);
}

QString shortDecimal(const Quantity &quantity, int places)
{
    const QString decimal = displayDecimal(quantity, places);
    if (!quantity.isFinite() || decimal.size() <= toDecimal(quantity, places).size() + 1)
        return decimal; // ends in an ellipsis
    const double whole = std::round(quantity.toDouble());
    const double rest = errorOf(quantity, Quantity::of(whole));
    return withMinus(QString::number(whole, 'f', 0)) + (rest < 0 ? u" − "_s : u" + "_s)
        + withMinus(QString::asprintf("%.0e", std::abs(rest)));
}

QString decimalBeside(const Quantity &quantity, Arithmetic arithmetic)
{
    const bool isFraction
        = quantity.isRational() && displayText(quantity, arithmetic).contains(u'/');
    if (!isFraction)
        return {};
    QString decimal = displayDecimal(quantity);
    if (decimal.endsWith(ellipsis))
        return u"≈ "_s + decimal;
    while (decimal.endsWith(u'0'))
        decimal.chop(1);
    return u"= "_s + decimal;
}

QString displayError(const Quantity &used, const Quantity &exact)
{
    if (used.isNone() || exact.isNone() || !exact.isFinite())
        return {};
    if (!used.isFinite())
        return nonFiniteText(used.toDouble());
    const double error = errorOf(used, exact);
    if (used.isInteger() && exact.isInteger() && std::abs(error) < 1e6)
        return error == 0 ? u"0"_s : withMinus(QString::asprintf("%+.0f", error));
    return error == 0 ? u"0"_s : withMinus(QString::asprintf("%+.1e", error));
}

void keepDecimalPoint() { QLocale::setDefault(QLocale::c()); }

QString groupedText(std::int64_t number)
{
    return groupingLocale().toString(qlonglong(number)).replace(u',', narrowSpace);
}

QString groupedText(double number, int places)
{
    return groupingLocale().toString(number, 'f', places).replace(u',', narrowSpace);
}

int firstDifferingDigit(const QString &used, const QString &exactDecimal)
{
    const bool unknownTail = exactDecimal.endsWith(ellipsis);
    const qsizetype known = exactDecimal.size() - qsizetype(unknownTail);
    const qsizetype common = std::min(used.size(), known);
    for (qsizetype i = 0; i < common; ++i) {
        if (used[i] != exactDecimal[i])
            return int(i);
    }
    if (unknownTail)
        return -1;
    for (qsizetype i = known; i < used.size(); ++i) {
        const bool continuesInZeros = used[i] == u'0' || used[i] == u'.';
        if (!continuesInZeros && used[i] != ellipsis)
            return int(i);
    }
    return -1;
}

} // namespace pixelplumb
