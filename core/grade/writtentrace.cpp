// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/writtentrace.h"

#include "core/grade/showntext.h"

#include <QList>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace pixelplumb {

namespace {

constexpr qsizetype longestLine = 200;
constexpr qsizetype longestShown = 60;
constexpr std::size_t mostLines = std::size_t(1) << 22;
constexpr qsizetype mostExactDigits = 18; // that 64 bits hold

bool isDigits(const QByteArray &text)
{
    return !text.isEmpty()
        && std::ranges::all_of(text, [](char each) { return each >= '0' && each <= '9'; });
}

QByteArray withoutSign(const QByteArray &text)
{
    return text.startsWith('-') || text.startsWith('+') ? text.sliced(1) : text;
}

/// "290/7"
std::optional<Quantity> fractionOf(const QByteArray &text)
{
    const qsizetype slash = text.indexOf('/');
    const QByteArray above = text.left(slash);
    const QByteArray below = text.mid(slash + 1);
    if (slash < 0 || !isDigits(withoutSign(above)) || !isDigits(below)
        || above.size() > mostExactDigits || below.size() > mostExactDigits
        || below.toLongLong() == 0)
        return std::nullopt;
    return Quantity::rational(above.toLongLong(), below.toLongLong());
}

/// "41.5", "-7", "4.15e1", "nan"
std::optional<WrittenNumber> decimalOf(const QByteArray &text)
{
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    if (!isNumber)
        return std::nullopt;
    WrittenNumber number{QString::fromLatin1(text), Quantity::of(value), 0, false};
    if (!std::isfinite(value))
        return number;
    const QByteArray lower = text.toLower();
    const qsizetype exponentAt = lower.indexOf('e');
    const int exponent = exponentAt < 0 ? 0 : lower.mid(exponentAt + 1).toInt();
    const QByteArray mantissa = exponentAt < 0 ? text : text.left(exponentAt);
    const qsizetype point = mantissa.indexOf('.');
    const qsizetype places = point < 0 ? 0 : mantissa.size() - point - 1;
    number.isWhole = point < 0 && exponentAt < 0;
    if (!number.isWhole)
        number.halfUnit = std::min(0.5, std::pow(10.0, exponent - double(places)) / 2);
    QByteArray digits = mantissa;
    digits.replace(".", "");
    if (exponentAt < 0 && digits.size() <= mostExactDigits) {
        Int128 unit = 1;
        for (qsizetype i = 0; i < places; ++i)
            unit *= 10;
        number.value = Quantity::rational(digits.toLongLong(), unit);
    }
    return number;
}

std::optional<WrittenNumber> numberOf(const QByteArray &text)
{
    if (const auto fraction = fractionOf(text))
        return WrittenNumber{QString::fromLatin1(text), *fraction, 0, false};
    return decimalOf(text);
}

std::optional<std::int64_t> coordinateOf(const QByteArray &text)
{
    bool isNumber = false;
    const int value = text.toInt(&isNumber);
    return isNumber ? std::optional<std::int64_t>(value) : std::nullopt;
}

/// The coordinates and then the numbers of a line.
bool takeWords(const QList<QByteArray> &words, std::span<std::int64_t *const> coordinates,
               std::size_t numbers, WrittenLine &line)
{
    if (std::size_t(words.size()) != 1 + coordinates.size() + numbers)
        return false;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const auto coordinate = coordinateOf(words[qsizetype(i) + 1]);
        if (!coordinate)
            return false;
        *coordinates[i] = *coordinate;
    }
    for (std::size_t i = 0; i < numbers; ++i) {
        const auto number = numberOf(words[1 + qsizetype(coordinates.size()) + qsizetype(i)]);
        if (!number)
            return false;
        line.numbers.push_back(*number);
    }
    return true;
}

bool takeLine(const QList<QByteArray> &words, WrittenLine &line)
{
    if (words[0] == "column") {
        line.axis = SpanAxis::Column;
        return takeWords(words, std::array<std::int64_t *const, 1>{&line.x}, 2, line);
    }
    if (words[0] == "row") {
        line.axis = SpanAxis::Row;
        return takeWords(words, std::array<std::int64_t *const, 1>{&line.y}, 2, line);
    }
    return words[0] == "pixel"
        && takeWords(words, std::array<std::int64_t *const, 2>{&line.x, &line.y}, 3, line);
}

} // namespace

Result<std::vector<WrittenLine>> parseWrittenTrace(const QByteArray &text)
{
    std::vector<WrittenLine> lines;
    std::optional<std::size_t> triangle;
    qsizetype number = 0;
    for (qsizetype start = 0; start < text.size();) {
        qsizetype end = text.indexOf('\n', start);
        end = end < 0 ? text.size() : end;
        const QByteArray whole = text.mid(start, std::min(end - start, longestLine + 1));
        start = end + 1;
        ++number;
        const QByteArray content = whole.simplified();
        if (content.isEmpty())
            continue;
        const QList<QByteArray> words = content.split(' ');
        WrittenLine line;
        if (words[0] == "triangle" && words.size() == 2 && isDigits(words[1])
            && words[1].size() <= 9) {
            triangle = words[1].toULongLong();
            continue;
        }
        if (whole.size() > longestLine || lines.size() >= mostLines || !takeLine(words, line))
            return InputError{QStringLiteral("line %1 of the output").arg(number),
                              QStringLiteral("“%1”").arg(shownText(content, longestShown)),
                              QStringLiteral("column x y_B y_T, row y x_L x_R, pixel x y R G B or "
                                             "triangle n")};
        line.triangle = triangle;
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace pixelplumb
