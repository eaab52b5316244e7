// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/formularange.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pixelplumb {

namespace {

/// Reads a formula by recursive descent, evaluating it on the way.
class FormulaReader {
public:
    FormulaReader(const QString &text, const RangeArithmetic &arithmetic)
        : m_text(text)
        , m_arithmetic(arithmetic)
    {
    }

    std::optional<NumberRange> result()
    {
        const NumberRange range = choice();
        if (m_failed || m_place != m_text.size() || std::isnan(range.least)
            || std::isnan(range.greatest))
            return std::nullopt;
        return range;
    }

private:
    using Number = long double;

    QChar next() const { return m_place < m_text.size() ? m_text[m_place] : QChar(); }
    bool takes(QChar character)
    {
        if (next() != character)
            return false;
        ++m_place;
        return true;
    }
    bool takesWord(QStringView word)
    {
        if (!QStringView(m_text).sliced(m_place).startsWith(word))
            return false;
        m_place += word.size();
        return true;
    }
    void skipBlanks()
    {
        while (next() == u' ')
            ++m_place;
    }
    void expect(QChar character)
    {
        skipBlanks();
        m_failed = !takes(character) || m_failed;
    }

    /// "1 if 3 > 2, else 0": both values if the known digits do not decide.
    NumberRange choice()
    {
        const NumberRange value = sum();
        skipBlanks();
        if (!takesWord(u"if "))
            return value;
        const NumberRange left = sum();
        skipBlanks();
        const bool isLess = takes(u'<');
        m_failed = m_failed || (!isLess && !takes(u'>'));
        const NumberRange right = sum();
        expect(u',');
        m_failed = !takesWord(u" else ") || m_failed;
        const NumberRange other = sum();
        const NumberRange &small = isLess ? left : right;
        const NumberRange &large = isLess ? right : left;
        if (small.greatest < large.least)
            return value;
        if (small.least >= large.greatest)
            return other;
        return {std::min(value.least, other.least), std::max(value.greatest, other.greatest)};
    }
    NumberRange sum()
    {
        NumberRange value = product();
        for (;;) {
            skipBlanks();
            if (takes(u'+')) {
                value = m_arithmetic.sum(value, product());
            } else if (takes(u'−')) {
                value = m_arithmetic.sum(value, negated(product()));
            } else {
                return value;
            }
        }
    }
    NumberRange product()
    {
        NumberRange value = factor();
        for (;;) {
            if (takes(u'·'))
                value = m_arithmetic.product(value, factor());
            else if (takes(u'/'))
                value = orFailed(m_arithmetic.quotient(value, factor()));
            else if (takesWord(u" mod "))
                value = orFailed(RangeArithmetic::remainder(value, factor()));
            else
                return value;
        }
    }
    NumberRange orFailed(const std::optional<NumberRange> &range)
    {
        m_failed = m_failed || !range;
        return range.value_or(NumberRange());
    }
    static NumberRange negated(const NumberRange &range) { return {-range.greatest, -range.least}; }
    NumberRange factor()
    {
        NumberRange value = base();
        while (takes(u'²'))
            value = m_arithmetic.product(value, value);
        if (takes(u'^'))
            value = m_arithmetic.power(value, int(digits()));
        return value;
    }
    NumberRange base()
    {
        skipBlanks();
        if (takes(u'−'))
            return negated(factor());
        if (takes(u'√'))
            return m_arithmetic.root(factor());
        // A cast drops the fraction, of negative numbers too.
        if (takesWord(u"(int)")) {
            const NumberRange value = factor();
            return {std::trunc(value.least), std::trunc(value.greatest)};
        }
        if (takesWord(u"cos "))
            return m_arithmetic.turned(factor(), std::cos);
        if (takesWord(u"sin "))
            return m_arithmetic.turned(factor(), std::sin);
        if (takes(u'(')) {
            const NumberRange value = sum();
            expect(u')');
            return value;
        }
        if (takes(u'⌈')) {
            const NumberRange value = sum();
            expect(u'⌉');
            return {std::ceil(value.least), std::ceil(value.greatest)};
        }
        if (takes(u'⌊')) {
            const NumberRange value = sum();
            expect(u'⌋');
            return {std::floor(value.least), std::floor(value.greatest)};
        }
        if (takesWord(u"min("))
            return extreme([](Number a, Number b) { return std::min(a, b); });
        if (takesWord(u"max("))
            return extreme([](Number a, Number b) { return std::max(a, b); });
        if (takes(u'π'))
            return {std::numbers::pi_v<Number>, std::numbers::pi_v<Number>};
        return takes(u'½') ? NumberRange{0.5L, 0.5L} : number();
    }
    /// The extreme of all values up to the closing parenthesis.
    template <class Choice>
    NumberRange extreme(const Choice &choice)
    {
        NumberRange value = sum();
        skipBlanks();
        while (takes(u',')) {
            const NumberRange other = sum();
            value = {choice(value.least, other.least), choice(value.greatest, other.greatest)};
            skipBlanks();
        }
        expect(u')');
        return value;
    }
    NumberRange number()
    {
        const Number sign = takes(u'-') ? -1 : 1;
        Number value = digits();
        // "17 3/8": a blank and a digit follow the whole part.
        Number slack = 0;
        if (next() == u' ' && m_place + 1 < m_text.size() && m_text[m_place + 1].isDigit()) {
            ++m_place;
            const Number numerator = digits();
            m_failed = !takes(u'/') || m_failed;
            value += numerator / digits();
            slack = NumberRange::ownRounding * value;
        }
        // "0.333333…": the last digit is rounded, or the later digits are cut off.
        const Number unseen = slack + (takes(u'…') ? m_lastDigit : 0);
        return m_arithmetic.shown({sign * value - unseen, sign * value + unseen});
    }
    /// "12", "0.5", "1e-07"
    Number digits()
    {
        const qsizetype first = m_place;
        qsizetype point = -1;
        for (; next().isDigit() || next() == u'.'; ++m_place)
            point = next() == u'.' ? m_place : point;
        const qsizetype places = point < 0 ? 0 : m_place - point - 1;
        const qsizetype exponent = m_place;
        if (next() == u'e' && m_place > first) {
            ++m_place;
            if (next() == u'-' || next() == u'−' || next() == u'+')
                ++m_place;
            while (next().isDigit())
                ++m_place;
        }
        const QByteArray digits
            = m_text.sliced(first, m_place - first).replace(u'−', u'-').toLatin1();
        char *end = nullptr;
        const Number value = std::strtold(digits.constData(), &end);
        m_failed = m_failed || digits.isEmpty() || *end != '\0';
        const QString power
            = m_text.sliced(exponent, m_place - exponent).mid(1).replace(u'−', u'-');
        m_lastDigit = std::pow(10.0L, Number(power.toInt() - int(places)));
        return value;
    }

    QString m_text;
    const RangeArithmetic &m_arithmetic;
    qsizetype m_place = 0;
    Number m_lastDigit = 1; ///< one unit of the last digit that was read
    bool m_failed = false;
};

} // namespace

std::optional<FormulaRange> FormulaRange::of(const QString &text, Arithmetic arithmetic)
{
    return workedOut(text, {arithmetic, RangeArithmetic::Overflow::Never});
}

std::optional<FormulaRange> FormulaRange::wrappedOf(const QString &text, Arithmetic arithmetic)
{
    return workedOut(text, {arithmetic, RangeArithmetic::Overflow::Wraps});
}

std::optional<FormulaRange> FormulaRange::workedOut(const QString &text,
                                                    const RangeArithmetic &arithmetic)
{
    const auto range = FormulaReader(text, arithmetic).result();
    return range ? std::optional(FormulaRange(*range)) : std::nullopt;
}

bool FormulaRange::holds(const Quantity &number) const
{
    const long double value = number.isRational() ? static_cast<long double>(number.numerator())
            / static_cast<long double>(number.denominator())
                                                  : static_cast<long double>(number.toDouble());
    const long double slack = NumberRange::ownRounding * std::abs(value);
    return value >= m_range.least - slack && value <= m_range.greatest + slack;
}

bool FormulaRange::isNarrow() const
{
    if (!m_range.isFinite())
        return false;
    return m_range.greatest - m_range.least
        <= 0.01L * std::max(std::abs(m_range.least), std::abs(m_range.greatest))
        || m_range.greatest - m_range.least <= 0.0001L;
}

QString FormulaRange::text() const
{
    return u"%1 … %2"_s.arg(double(m_range.least), 0, 'g', 17)
        .arg(double(m_range.greatest), 0, 'g', 17);
}

namespace {

/// "y_B ← y_B′ + m₀₂": the left side and the right side.
std::pair<QString, QString> sidesOf(const QString &symbols)
{
    for (const QChar sign : {QChar(u'←'), QChar(u'=')}) {
        if (const qsizetype place = symbols.indexOf(sign); place >= 0)
            return {symbols.first(place).trimmed(), symbols.sliced(place + 1).trimmed()};
    }
    return {symbols, symbols};
}

} // namespace

QString formulaFault(const FormulaLine &line, const std::optional<FormulaRange> &range,
                     Arithmetic arithmetic)
{
    const auto [left, right] = sidesOf(line.symbols);
    if (left == right)
        return u"says nothing"_s;
    if (!range)
        return u"cannot be worked out"_s;
    if (range->holds(line.used))
        return QString();
    const auto wrapped = FormulaRange::wrappedOf(line.substituted, arithmetic);
    return wrapped && wrapped->holds(line.used) ? QString() : u"gives "_s + range->text();
}

} // namespace pixelplumb
