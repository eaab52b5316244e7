// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/try/writtentrace.h"

#include "core/grade/showntext.h"
#include "core/number/wideinteger.h"

#include <QList>

#include <algorithm>
#include <array>
#include <cmath>

namespace pixelplumb {

namespace {

constexpr qsizetype longestLine = 200;
constexpr qsizetype longestShown = 60;
constexpr std::int64_t mostLines = std::int64_t(1) << 22;
constexpr qsizetype mostExactDigits = 18; // that fit in 64 bits

bool isDigits(const QByteArray &text)
{
    return !text.isEmpty()
        && std::ranges::all_of(text, [](char each) { return each >= '0' && each <= '9'; });
}

QByteArray withoutSign(const QByteArray &text)
{
    return text.startsWith('-') || text.startsWith('+') ? text.sliced(1) : text;
}

BigInteger integerOf(QByteArray digits)
{
    while (digits.size() > 1 && digits.startsWith('0')) // Boost takes it for octal
        digits.remove(0, 1);
    return BigInteger(digits.constData());
}

/// "290/7"; to the last bit of a double where its parts are too long.
std::optional<Quantity> fractionOf(const QByteArray &text)
{
    const qsizetype slash = text.indexOf('/');
    const QByteArray above = text.left(slash);
    const QByteArray below = text.mid(slash + 1);
    if (slash < 0 || !isDigits(withoutSign(above)) || !isDigits(below)
        || below.count('0') == below.size())
        return std::nullopt;
    const BigRational magnitude(integerOf(withoutSign(above)), integerOf(below));
    const BigRational value = above.startsWith('-') ? BigRational(-magnitude) : magnitude;
    const BigInteger most = BigInteger(1) << 62;
    if (abs(numerator(value)) < most && denominator(value) < most)
        return Quantity::rational(Int128(numerator(value)), Int128(denominator(value)));
    return Quantity::of(value.convert_to<double>());
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

std::optional<std::int32_t> coordinateOf(const QByteArray &text)
{
    bool isNumber = false;
    const int value = text.toInt(&isNumber);
    return isNumber ? std::optional<std::int32_t>(value) : std::nullopt;
}

/// The parts of a line of one kind, after its first word.
struct WrittenForm {
    const char *word;
    std::optional<SpanAxis> axis;
    qsizetype coordinates;
    qsizetype numbers;
};
constexpr std::array writtenForms
    = {WrittenForm{"column", SpanAxis::Column, 1, 2}, WrittenForm{"row", SpanAxis::Row, 1, 2},
       WrittenForm{"pixel", std::nullopt, 2, 3}};

/// None where a word is no number.
std::optional<std::vector<WrittenNumber>> numbersIn(const QList<QByteArray> &words,
                                                    const WrittenForm &form)
{
    std::vector<WrittenNumber> numbers;
    for (qsizetype i = 1 + form.coordinates; i < words.size(); ++i) {
        auto number = numberOf(words[i]);
        if (!number)
            return std::nullopt;
        numbers.push_back(std::move(*number));
    }
    return numbers;
}

bool takeLine(const QList<QByteArray> &words, WrittenLine &line)
{
    const auto form = std::ranges::find_if(
        writtenForms, [&words](const WrittenForm &each) { return words[0] == each.word; });
    // Qt takes a NUL for a number's end.
    const auto hasNul = [](const QByteArray &word) { return word.contains('\0'); };
    if (form == writtenForms.end() || words.size() != 1 + form->coordinates + form->numbers
        || std::ranges::any_of(words, hasNul) || !numbersIn(words, *form))
        return false;
    const auto first = coordinateOf(words[1]);
    const auto second = form->axis ? first : coordinateOf(words[2]);
    if (!first || !second)
        return false;
    line.axis = form->axis;
    line.x = line.axis == SpanAxis::Row ? 0 : *first;
    line.y = line.axis == SpanAxis::Column ? 0 : *second;
    return true;
}

/// From `start` to the line's end, cut one byte beyond the longest line.
QByteArray lineAt(const QByteArray &text, qsizetype start)
{
    const qsizetype end = text.indexOf('\n', start);
    return text.mid(start, std::min((end < 0 ? text.size() : end) - start, longestLine + 1));
}

bool isInFrame(const WrittenLine &line, const FrameSpec &frame)
{
    const std::int64_t x = std::int64_t(line.x) - frame.firstColumn;
    const std::int64_t y = std::int64_t(line.y) - frame.firstRow;
    return (line.axis == SpanAxis::Row || (x >= 0 && x < frame.width))
        && (line.axis == SpanAxis::Column || (y >= 0 && y < frame.height));
}

bool &kindOf(const WrittenLine &line, LineKinds &kinds)
{
    if (!line.axis)
        return kinds.hasPixels;
    return *line.axis == SpanAxis::Column ? kinds.hasColumns : kinds.hasRows;
}

} // namespace

std::vector<WrittenNumber> ProgramTrace::numbersOf(const WrittenLine &line) const
{
    const QList<QByteArray> words = lineAt(text, line.start).simplified().split(' ');
    const auto form = std::ranges::find(writtenForms, line.axis, &WrittenForm::axis);
    return numbersIn(words, *form).value_or(std::vector<WrittenNumber>());
}

Result<ProgramTrace> parseWrittenTrace(const QByteArray &text, const FrameSpec &frame)
{
    ProgramTrace trace{text, {}, 0, {}, std::nullopt};
    std::optional<std::uint32_t> triangle;
    std::int64_t number = 0;
    for (qsizetype start = 0, next = 0; start < text.size(); start = next) {
        const qsizetype end = text.indexOf('\n', start);
        next = end < 0 ? text.size() : end + 1;
        const QByteArray whole = lineAt(text, start);
        ++number;
        const QByteArray content = whole.simplified();
        if (content.isEmpty())
            continue;
        const QList<QByteArray> words = content.split(' ');
        if (words[0] == "triangle" && words.size() == 2 && isDigits(words[1])
            && words[1].size() <= 9) {
            triangle = words[1].toUInt();
            trace.lastTriangle = std::max(trace.lastTriangle.value_or(0), *triangle);
            continue;
        }
        WrittenLine line;
        const std::int64_t before = std::ssize(trace.lines) + trace.beyondFrame;
        const QString place = u"line %1 of the output"_s.arg(number);
        if (before >= mostLines)
            return InputError{place, u"one more column, row or pixel"_s,
                              u"at most %1 of them"_s.arg(mostLines)};
        const bool isTooLong = whole.size() > longestLine;
        if (isTooLong || !takeLine(words, line))
            return InputError{
                place, u"“%1”"_s.arg(shownText(content, longestShown)),
                u"column x y_B y_T, row y x_L x_R, pixel x y R G B or triangle n"_s
                    + (isTooLong ? u", in at most %1 bytes"_s.arg(longestLine) : QString())};
        kindOf(line, trace.kinds) = true;
        line.triangle = triangle;
        line.start = start;
        if (isInFrame(line, frame))
            trace.lines.push_back(line);
        else
            ++trace.beyondFrame;
    }
    return trace;
}

} // namespace pixelplumb
