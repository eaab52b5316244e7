// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/text/coordinatetext.h"

#include "core/scene/text/shortened.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <limits>

namespace pixelplumb {

namespace {

/// Larger exponents make no difference: such a number is zero, or far out of range.
constexpr int largestExponent = 999;

using Natural = boost::multiprecision::cpp_int;

/// A written value; denominator > 0.
struct WrittenValue {
    bool negative = false;
    Natural numerator;
    Natural denominator = 1;
};

/// Digits 0 … 9 only; none for an empty text or anything else.
std::optional<Natural> naturalOf(QStringView digits)
{
    const auto isDigit = [](QChar each) { return each >= u'0' && each <= u'9'; };
    if (digits.isEmpty() || !std::ranges::all_of(digits, isDigit))
        return std::nullopt;
    while (digits.size() > 1 && digits.front() == u'0') // Boost takes it for octal
        digits = digits.sliced(1);
    return Natural(digits.toLatin1().constData());
}

Natural powerOfTen(int exponent)
{
    return boost::multiprecision::pow(Natural(10), unsigned(exponent));
}

QStringView takeSign(QStringView text, bool &negative)
{
    constexpr QChar minusSign(0x2212);
    negative = text.startsWith(u'-') || text.startsWith(minusSign);
    return negative || text.startsWith(u'+') ? text.sliced(1) : text;
}

/// "53/2"
std::optional<WrittenValue> parseFraction(QStringView text)
{
    const qsizetype slash = text.indexOf(u'/');
    if (slash < 0)
        return std::nullopt;
    const auto numerator = naturalOf(text.first(slash));
    const auto denominator = naturalOf(text.sliced(slash + 1));
    if (!numerator || !denominator)
        return std::nullopt;
    return WrittenValue{false, *numerator, *denominator};
}

/// "26 1/2", with any kind of space
std::optional<WrittenValue> parseMixed(QStringView text)
{
    qsizetype wholeLength = 0;
    while (wholeLength < text.size() && !text[wholeLength].isSpace())
        ++wholeLength;
    const auto whole = naturalOf(text.first(wholeLength));
    auto fraction = parseFraction(text.sliced(wholeLength).trimmed());
    if (!whole || !fraction)
        return std::nullopt;
    fraction->numerator = fraction->numerator + *whole * fraction->denominator;
    return fraction;
}

/// "2.65e1": digits with an optional point, then an optional exponent
std::optional<WrittenValue> parseDecimal(QStringView text)
{
    int exponent = 0;
    const qsizetype mark = qMax(text.indexOf(u'e'), text.indexOf(u'E'));
    if (mark >= 0) {
        bool negative = false;
        const auto power = naturalOf(takeSign(text.sliced(mark + 1), negative));
        if (!power)
            return std::nullopt;
        exponent
            = std::min<Natural>(*power, largestExponent).convert_to<int>() * (negative ? -1 : 1);
        text = text.first(mark);
    }
    QString digits = text.toString();
    const qsizetype point = digits.indexOf(u'.');
    if (point >= 0) {
        exponent -= int(digits.size() - point - 1);
        digits.remove(point, 1);
    }
    const auto significand = naturalOf(digits);
    if (!significand)
        return std::nullopt;
    WrittenValue value;
    value.numerator = *significand * powerOfTen(qMax(0, exponent));
    value.denominator = powerOfTen(qMax(0, -exponent));
    return value;
}

std::optional<WrittenValue> parseValue(QStringView text)
{
    bool negative = false;
    text = takeSign(text, negative);
    std::optional<WrittenValue> value;
    if (!text.contains(u'/'))
        value = parseDecimal(text);
    else if (value = parseFraction(text); !value)
        value = parseMixed(text);
    if (value)
        value->negative = negative;
    return value;
}

/// The value as a rational if 64 bits hold its parts, else the nearest double.
Quantity quantityOf(const WrittenValue &value)
{
    constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
    if (value.numerator <= largest && value.denominator <= largest) {
        const Int128 magnitude = value.numerator.convert_to<std::uint64_t>();
        return Quantity::rational(value.negative ? -magnitude : magnitude,
                                  value.denominator.convert_to<std::uint64_t>());
    }
    const boost::multiprecision::cpp_rational ratio(value.numerator, value.denominator);
    // Never 0: a displacement too small for a double is still a displacement.
    const double magnitude
        = qMax(ratio.convert_to<double>(), std::numeric_limits<double>::denorm_min());
    return Quantity::of(value.negative ? -magnitude : magnitude);
}

InputError refusal(QStringView text, const QString &why, const NumberFormat &format)
{
    return {{}, why.arg(shortened(text.toString())), expectationOf(format)};
}

QString rangeText(const NumberFormat &format)
{
    return u"±%1%2"_s.arg(format.largest).arg(QLatin1String(format.unit));
}

/// Parses a value within the format's limits.
Result<WrittenValue> parseWithin(QStringView text, const NumberFormat &format)
{
    if (text.size() > longestNumberText)
        return refusal(text, "“%1” is longer than 400 characters", format);
    const QStringView trimmed = text.trimmed();
    const auto value = parseValue(trimmed);
    if (!value)
        return refusal(trimmed, u"“%1” is no "_s + QLatin1String(format.name), format);
    if (value->denominator == 0)
        return refusal(trimmed, "%1 divides by zero", format);
    if (format.largest * value->denominator < value->numerator)
        return refusal(trimmed, u"%1 is outside "_s + rangeText(format), format);
    return *value;
}

/// units / one − value, both over one * denominator.
Quantity displacementOf(std::int64_t units, std::int64_t one, const WrittenValue &value)
{
    const Natural used = absolute(units) * value.denominator;
    const Natural written = value.numerator * one;
    if (used == written)
        return Quantity::integer(0);
    // Away from zero is up for a positive value and down for a negative one.
    const bool awayFromZero = written < used;
    return quantityOf(
        {awayFromZero == value.negative, abs(used - written), value.denominator * one});
}

} // namespace

QString expectationOf(const NumberFormat &format)
{
    return u"a %1 such as %2 within %3"_s.arg(QLatin1String(format.name),
                                              QLatin1String(format.examples), rangeText(format));
}

Result<SnappedNumber> parseNumber(QStringView text, const NumberFormat &format)
{
    const Result<WrittenValue> value = parseWithin(text, format);
    if (!value)
        return value.error();
    // The number nearest to |value| is ⌊one·|v| + 1/2⌋; ties of a negative value go down in
    // magnitude, which is up on the number line.
    const Natural doubled = value->numerator * (2 * format.one) + value->denominator;
    Natural quotient;
    Natural remainder;
    divide_qr(doubled, Natural(2 * value->denominator), quotient, remainder);
    auto magnitude = quotient.convert_to<std::int64_t>(); // at most 2^45 after the range check
    if (value->negative && remainder == 0 && magnitude > 0)
        --magnitude;
    SnappedNumber snapped;
    snapped.units = value->negative ? -magnitude : magnitude;
    snapped.displacement = displacementOf(snapped.units, format.one, *value);
    return snapped;
}

Result<double> parseReal(QStringView text, const NumberFormat &format)
{
    const Result<WrittenValue> value = parseWithin(text, format);
    if (!value)
        return value.error();
    return value->numerator == 0 ? 0 : quantityOf(*value).toDouble();
}

QString numberText(std::int64_t units, const NumberFormat &format)
{
    const Int128 divisor = greatestCommonDivisor(units, format.one);
    const std::int64_t numerator = units / std::int64_t(divisor);
    const std::int64_t denominator = format.one / std::int64_t(divisor);
    const QString text = QString::number(numerator);
    return denominator == 1 ? text : text + u'/' + QString::number(denominator);
}

} // namespace pixelplumb
