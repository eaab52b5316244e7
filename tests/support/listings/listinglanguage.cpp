// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listings/listinglanguage.h"

#include <cmath>

namespace pixelplumb {

namespace {

using Number = BigRational;

Number floorOf(const Number &value)
{
    const BigInteger top = numerator(value), bottom = denominator(value);
    const BigInteger whole = top / bottom; // towards 0
    return Number(top < 0 && whole * bottom != top ? BigInteger(whole - 1) : whole);
}

/// Exact where the root is a fraction; else down to 2⁻⁶⁴.
Number rootOf(const Number &value)
{
    const auto root = [](const BigInteger &whole) { return BigInteger(sqrt(whole)); };
    const Number exact(root(numerator(value)), root(denominator(value)));
    if (exact * exact == value)
        return exact;
    const Number scale(BigInteger(1) << 64);
    return Number(root(BigInteger(numerator(floorOf(value * scale * scale))))) / scale;
}

enum class Operation { Add, Subtract, Multiply, Divide };

template <class Value>
Value resultOf(const Value &a, Operation operation, const Value &b)
{
    switch (operation) {
    case Operation::Add:
        return a + b;
    case Operation::Subtract:
        return a - b;
    case Operation::Multiply:
        return a * b;
    case Operation::Divide:
        break;
    }
    return a / b;
}

/// Numbers of the listing, computed by the machine's.
template <class Float>
Number resultIn(const Number &a, Operation operation, const Number &b)
{
    return Number(resultOf(a.convert_to<Float>(), operation, b.convert_to<Float>()));
}

/// Reads an expression from left to right.
class Reader {
public:
    Reader(const QString &text, const ListingNames &names, Arithmetic arithmetic)
        : m_text(text)
        , m_names(names)
        , m_arithmetic(arithmetic)
    {
    }

    Number result()
    {
        const Number value = sum();
        if (m_place != m_text.size())
            throw ListingFault(u"cannot read “%1”"_s.arg(m_text));
        return value;
    }

private:
    Number computed(const Number &a, Operation operation, const Number &b) const
    {
        if (m_arithmetic == Arithmetic::Float32)
            return resultIn<float>(a, operation, b);
        if (m_arithmetic == Arithmetic::Float64)
            return resultIn<double>(a, operation, b);
        return Number(resultOf(a, operation, b));
    }
    Number rooted(const Number &value) const
    {
        if (m_arithmetic == Arithmetic::Float32)
            return Number(std::sqrt(value.convert_to<float>()));
        if (m_arithmetic == Arithmetic::Float64)
            return Number(std::sqrt(value.convert_to<double>()));
        return rootOf(value);
    }
    bool takes(const QString &token)
    {
        if (!QStringView(m_text).sliced(m_place).startsWith(token))
            return false;
        m_place += token.size();
        return true;
    }
    Number sum()
    {
        Number value = product();
        for (;;) {
            if (takes(u" + "_s))
                value = computed(value, Operation::Add, product());
            else if (takes(u" − "_s))
                value = computed(value, Operation::Subtract, product());
            else
                return value;
        }
    }
    Number product()
    {
        Number value = factor();
        for (;;) {
            if (takes(u"·"_s)) {
                value = computed(value, Operation::Multiply, factor());
            } else if (takes(u"/"_s)) {
                const Number divisor = factor();
                if (divisor == 0)
                    throw ListingFault(u"divides by 0: "_s + m_text);
                value = computed(value, Operation::Divide, divisor);
            } else if (takes(u" mod "_s)) {
                const Number divisor = factor();
                value -= divisor * floorOf(value / divisor);
            } else {
                return value;
            }
        }
    }
    Number factor()
    {
        if (takes(u"−"_s))
            return -factor();
        if (takes(u"cos "_s))
            return m_arithmetic == Arithmetic::Float32
                ? Number(std::cos(factor().convert_to<float>()))
                : Number(std::cos(factor().convert_to<double>()));
        if (takes(u"sin "_s))
            return m_arithmetic == Arithmetic::Float32
                ? Number(std::sin(factor().convert_to<float>()))
                : Number(std::sin(factor().convert_to<double>()));
        if (takes(u"√"_s))
            return rooted(factor());
        const Number value = plainFactor();
        return takes(u"²"_s) ? computed(value, Operation::Multiply, value) : value;
    }
    Number plainFactor()
    {
        if (takes(u"(int)("_s)) {
            const Number value = upTo(u")"_s);
            return value < 0 ? -floorOf(-value) : floorOf(value);
        }
        if (takes(u"max("_s))
            return outermost([](const Number &a, const Number &b) { return a < b; });
        if (takes(u"min("_s))
            return outermost([](const Number &a, const Number &b) { return a > b; });
        if (takes(u"("_s))
            return upTo(u")"_s);
        if (takes(u"⌊"_s))
            return floorOf(upTo(u"⌋"_s));
        if (takes(u"⌈"_s))
            return -floorOf(-upTo(u"⌉"_s));
        if (takes(u"|"_s)) {
            const Number value = upTo(u"|"_s);
            return value < 0 ? Number(-value) : value;
        }
        if (takes(u"½"_s))
            return Number(1, 2);
        if (takes(u"¼"_s))
            return Number(1, 4);
        const qsizetype first = m_place;
        while (m_place < m_text.size() && m_text[m_place] >= u'0' && m_text[m_place] <= u'9')
            ++m_place;
        if (m_place == first)
            return named();
        const Number value(m_text.sliced(first, m_place - first).toStdString());
        // A number before a name multiplies: 2Δy
        return m_place < m_text.size() && m_text[m_place].isLetter()
            ? computed(value, Operation::Multiply, named())
            : value;
    }
    /// The last of "A, B)" in an order.
    template <class Before>
    Number outermost(Before before)
    {
        Number value = sum();
        while (takes(u", "_s)) {
            const Number other = sum();
            value = before(value, other) ? other : value;
        }
        if (!takes(u")"_s))
            throw ListingFault(u"not closed: "_s + m_text);
        return value;
    }
    Number upTo(const QString &end)
    {
        const Number value = sum();
        if (!takes(end))
            throw ListingFault(u"not closed: "_s + m_text);
        return value;
    }
    /// The end of the word that starts here, with an index: "z_near[3,4]".
    qsizetype endOfWord() const
    {
        qsizetype end = m_place;
        while (end < m_text.size() && belongsToName(m_text[end]))
            ++end;
        return end < m_text.size() && m_text[end] == u'[' ? m_text.indexOf(u']', end) + 1 : end;
    }
    /// The longest name that starts here and ends at a word boundary; most are one word.
    Number named()
    {
        const qsizetype ends = endOfWord();
        const auto word = m_names.find(m_text.sliced(m_place, ends - m_place));
        if (word != m_names.end() && m_text.mid(ends, 1) != u"("_s) {
            m_place = ends;
            return word->second;
        }
        const std::pair<const QString, Number> *longest = nullptr;
        const QString begin = m_text.mid(m_place, 1);
        for (auto entry = m_names.lower_bound(begin);
             entry != m_names.end() && entry->first.startsWith(begin); ++entry) {
            const qsizetype end = m_place + entry->first.size();
            if (QStringView(m_text).sliced(m_place).startsWith(entry->first)
                && (end == m_text.size() || !belongsToName(m_text[end]))
                && (!longest || entry->first.size() > longest->first.size()))
                longest = &*entry;
        }
        if (!longest)
            throw ListingFault(u"no value of “%1” in: %2"_s.arg(m_text.sliced(m_place), m_text));
        m_place += longest->first.size();
        return longest->second;
    }

    const QString &m_text;
    const ListingNames &m_names;
    Arithmetic m_arithmetic;
    qsizetype m_place = 0;
};

} // namespace

bool belongsToName(QChar character)
{
    const char16_t code = character.unicode();
    const bool isSubscript
        = (code >= 0x2080 && code <= 0x209C) || (code >= 0x1D62 && code <= 0x1D6A);
    return (character.isLetterOrNumber() && character != u'²') || character == u'_' || isSubscript;
}

QStringList listed(const QString &text)
{
    QStringList parts;
    int depth = 0;
    for (const QString &piece : text.split(u", "_s)) {
        if (depth > 0)
            parts.last() += u", "_s + piece;
        else
            parts += piece;
        depth += int(piece.count(u'(') - piece.count(u')'));
    }
    return parts;
}

BigRational valueOf(const QString &expression, const ListingNames &names, Arithmetic arithmetic)
{
    return Reader(expression, names, arithmetic).result();
}

} // namespace pixelplumb
