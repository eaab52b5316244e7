// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/formularange.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pixelplumb {

namespace {

/// How far an operation's result may be from the true one, relatively or absolutely.
struct RoundingStep {
    long double relative = 0;
    long double absolute = 0;
};

/// Twice what the arithmetic promises, so that a number that is shown by the shortest decimal that
/// reads back as the same is covered too. What long double itself rounds is added to all.
constexpr long double ownRounding = 0x1p-60L;

RoundingStep roundingOf(Arithmetic arithmetic)
{
    constexpr long double own = ownRounding;
    switch (arithmetic) {
    case Arithmetic::Exact:
        return {own, 0};
    case Arithmetic::Float32:
        return {0x1p-23L, 0x1p-148L};
    case Arithmetic::Float64:
        return {0x1p-52L, 0};
    case Arithmetic::Fixed16:
        return {own, 0x1p-16L};
    case Arithmetic::Fixed32:
        return {own, 0x1p-32L};
    }
    return {};
}

/// How far apart two numbers are that a fixed-point number cannot tell from each other; 0 where
/// there are none.
long double periodOf(Arithmetic arithmetic)
{
    if (arithmetic == Arithmetic::Fixed16)
        return 0x1p16L;
    return arithmetic == Arithmetic::Fixed32 ? 0x1p32L : 0;
}

} // namespace

/// Reads a formula by recursive descent and works it out on the way.
class FormulaReader {
public:
    FormulaReader(const QString &text, Arithmetic arithmetic, long double period)
        : m_text(text)
        , m_step(roundingOf(arithmetic))
        , m_period(period)
    {
    }

    std::optional<FormulaRange> result()
    {
        const FormulaRange range = sum();
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

    static FormulaRange between(Number least, Number greatest)
    {
        FormulaRange range;
        range.least = least;
        range.greatest = greatest;
        return range;
    }
    /// Sums of whole numbers are not rounded, nor are any of fixed-point numbers; these wrap.
    FormulaRange summed(Number least, Number greatest) const
    {
        const bool isWhole = least == greatest && std::floor(least) == least
            && std::abs(least) < 0x1p62L && m_step.relative <= ownRounding;
        return isWhole || m_step.absolute > ownRounding ? wrapped(between(least, greatest))
                                                        : rounded(between(least, greatest));
    }
    /// Of fixed-point numbers that leave their range only the low bits are kept.
    FormulaRange wrapped(const FormulaRange &range) const
    {
        if (m_period == 0 || !std::isfinite(range.least) || !std::isfinite(range.greatest))
            return range;
        const Number turns
            = std::floor((range.least + range.greatest) / 2 / m_period + Number(0.5));
        return between(range.least - turns * m_period, range.greatest - turns * m_period);
    }
    /// Anything: what two numbers that are shown alike leave of their quotient.
    static FormulaRange unknown()
    {
        constexpr Number infinity = std::numeric_limits<Number>::infinity();
        return between(-infinity, infinity);
    }
    /// An operation's result, with what the arithmetic may have rounded.
    FormulaRange rounded(const FormulaRange &range) const
    {
        if (!std::isfinite(range.least) || !std::isfinite(range.greatest))
            return unknown();
        const Number slack = m_step.absolute
            + m_step.relative * std::max(std::abs(range.least), std::abs(range.greatest));
        return between(range.least - slack, range.greatest + slack);
    }

    FormulaRange sum()
    {
        FormulaRange value = product();
        for (;;) {
            skipBlanks();
            if (takes(u'+')) {
                const FormulaRange other = product();
                value = summed(value.least + other.least, value.greatest + other.greatest);
            } else if (takes(u'−')) {
                const FormulaRange other = product();
                value = summed(value.least - other.greatest, value.greatest - other.least);
            } else {
                return value;
            }
        }
    }
    FormulaRange product()
    {
        FormulaRange value = factor();
        for (;;) {
            if (takes(u'·'))
                value = multiplied(value, factor());
            else if (takes(u'/'))
                value = divided(value, factor());
            else if (takesWord(u" mod "))
                value = remainder(value, factor());
            else
                return value;
        }
    }
    /// Of numbers that are shown whole.
    FormulaRange remainder(const FormulaRange &a, const FormulaRange &b)
    {
        const Number whole = std::round(a.least), divisor = std::round(b.least);
        m_failed = m_failed || divisor == 0;
        const Number rest = m_failed ? 0 : std::fmod(whole, divisor);
        return between(rest, rest);
    }
    FormulaRange multiplied(const FormulaRange &a, const FormulaRange &b) const
    {
        const auto [least, greatest] = std::minmax({a.least * b.least, a.least * b.greatest,
                                                    a.greatest * b.least, a.greatest * b.greatest});
        return wrapped(rounded(between(least, greatest)));
    }
    FormulaRange divided(const FormulaRange &a, const FormulaRange &b)
    {
        if (b.least == 0 && b.greatest == 0) {
            m_failed = true;
            return {};
        }
        if (b.least <= 0 && b.greatest >= 0)
            return unknown();
        const auto [least, greatest] = std::minmax({a.least / b.least, a.least / b.greatest,
                                                    a.greatest / b.least, a.greatest / b.greatest});
        return wrapped(rounded(between(least, greatest)));
    }
    FormulaRange factor()
    {
        FormulaRange value = base();
        while (takes(u'²'))
            value = multiplied(value, value);
        return value;
    }
    FormulaRange base()
    {
        skipBlanks();
        if (takes(u'−')) {
            const FormulaRange value = factor();
            return between(-value.greatest, -value.least);
        }
        if (takes(u'√')) {
            const FormulaRange value = factor();
            return rounded(between(std::sqrt(std::max(value.least, Number(0))),
                                   std::sqrt(std::max(value.greatest, Number(0)))));
        }
        // What a cast does: it drops the fraction of negative numbers too.
        if (takesWord(u"(int)")) {
            const FormulaRange value = factor();
            return between(std::trunc(value.least), std::trunc(value.greatest));
        }
        if (takesWord(u"cos "))
            return turned(factor(), [](Number angle) { return std::cos(angle); });
        if (takesWord(u"sin "))
            return turned(factor(), [](Number angle) { return std::sin(angle); });
        if (takes(u'(')) {
            const FormulaRange value = sum();
            expect(u')');
            return value;
        }
        if (takes(u'⌈')) {
            const FormulaRange value = sum();
            expect(u'⌉');
            return between(std::ceil(value.least), std::ceil(value.greatest));
        }
        if (takes(u'⌊')) {
            const FormulaRange value = sum();
            expect(u'⌋');
            return between(std::floor(value.least), std::floor(value.greatest));
        }
        if (takesWord(u"min(")) {
            const auto [a, b] = pair();
            return between(std::min(a.least, b.least), std::min(a.greatest, b.greatest));
        }
        if (takesWord(u"max(")) {
            const auto [a, b] = pair();
            return between(std::max(a.least, b.least), std::max(a.greatest, b.greatest));
        }
        return takes(u'½') ? between(0.5L, 0.5L) : number();
    }
    /// A sine or cosine, whose slope is never more than 1.
    template <class Function>
    FormulaRange turned(const FormulaRange &angle, const Function &function) const
    {
        const Number middle = function((angle.least + angle.greatest) / 2);
        const Number reach = (angle.greatest - angle.least) / 2;
        return rounded(between(middle - reach, middle + reach));
    }
    std::pair<FormulaRange, FormulaRange> pair()
    {
        const FormulaRange first = sum();
        expect(u',');
        const FormulaRange second = sum();
        expect(u')');
        return {first, second};
    }
    FormulaRange number()
    {
        const Number sign = takes(u'-') ? -1 : 1;
        Number value = digits();
        // "17 3/8": a blank and a digit follow the whole.
        Number slack = 0;
        if (next() == u' ' && m_place + 1 < m_text.size() && m_text[m_place + 1].isDigit()) {
            ++m_place;
            const Number numerator = digits();
            m_failed = !takes(u'/') || m_failed;
            value += numerator / digits();
            slack = ownRounding * value;
        }
        // "0.333333…": the last digit is rounded, or the digits after it are cut off.
        const Number unseen = slack + (takes(u'…') ? m_lastDigit : 0);
        const FormulaRange seen = between(sign * value - unseen, sign * value + unseen);
        return m_step.relative > ownRounding ? rounded(seen) : seen;
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
            if (next() == u'-' || next() == u'+')
                ++m_place;
            while (next().isDigit())
                ++m_place;
        }
        const QByteArray digits = m_text.sliced(first, m_place - first).toLatin1();
        char *end = nullptr;
        const Number value = std::strtold(digits.constData(), &end);
        m_failed = m_failed || digits.isEmpty() || *end != '\0';
        const QString power = m_text.sliced(exponent, m_place - exponent).mid(1);
        m_lastDigit = std::pow(10.0L, Number(power.toInt() - int(places)));
        return value;
    }

    QString m_text;
    RoundingStep m_step;
    Number m_period; ///< of fixed-point numbers that wrap; 0: they do not
    qsizetype m_place = 0;
    Number m_lastDigit = 1; ///< what 1 is in the last digit that was read
    bool m_failed = false;
};

std::optional<FormulaRange> FormulaRange::of(const QString &text, Arithmetic arithmetic)
{
    return FormulaReader(text, arithmetic, 0).result();
}

std::optional<FormulaRange> FormulaRange::wrappedOf(const QString &text, Arithmetic arithmetic)
{
    return FormulaReader(text, arithmetic, periodOf(arithmetic)).result();
}

bool FormulaRange::holds(const Quantity &number) const
{
    const long double value = number.isRational() ? static_cast<long double>(number.numerator())
            / static_cast<long double>(number.denominator())
                                                  : static_cast<long double>(number.toDouble());
    const long double slack = ownRounding * std::abs(value);
    return value >= least - slack && value <= greatest + slack;
}

bool FormulaRange::isNarrow() const
{
    if (!std::isfinite(least) || !std::isfinite(greatest))
        return false;
    return greatest - least <= 0.01L * std::max(std::abs(least), std::abs(greatest))
        || greatest - least <= 0.0001L;
}

QString FormulaRange::text() const
{
    return QStringLiteral("%1 … %2")
        .arg(double(least), 0, 'g', 17)
        .arg(double(greatest), 0, 'g', 17);
}

} // namespace pixelplumb
