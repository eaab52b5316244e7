// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/listinglanguage.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <vector>

namespace pixelplumb {

namespace {

using Number = BigRational;

const QString likewise = QStringLiteral(" likewise");

bool belongsToName(QChar character)
{
    const char16_t code = character.unicode();
    const bool isSubscript
        = (code >= 0x2080 && code <= 0x209C) || (code >= 0x1D62 && code <= 0x1D6A);
    return character.isLetterOrNumber() || character == u'_' || isSubscript;
}

/// Replaces one of three names by the next one: "bc" → "ca".
struct Cycle {
    std::array<QString, 3> each;
    QString before, after; ///< what must surround the name; an empty `after` means the name's end

    qsizetype stepAt(const QString &text, qsizetype place, QString &result) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const QString whole = before + each[i] + after;
            if (!QStringView(text).sliced(place).startsWith(whole))
                continue;
            const qsizetype end = place + whole.size();
            const bool ends = !after.isEmpty() || end == text.size() || !belongsToName(text[end]);
            if (!before.isEmpty() && !ends)
                continue;
            result += before + each[(i + 1) % 3] + after;
            return whole.size();
        }
        return 0;
    }
};

QString turned(const QString &text, const std::vector<Cycle> &cycles)
{
    QString result;
    for (qsizetype place = 0; place < text.size();) {
        qsizetype taken = 0;
        for (const Cycle &cycle : cycles) {
            if ((taken = cycle.stepAt(text, place, result)) > 0)
                break;
        }
        if (taken == 0)
            result += text[place];
        place += std::max<qsizetype>(taken, 1);
    }
    return result;
}

/// The text with the next edge, its vertices and the weight of the opposite vertex.
QString nextEdge(const QString &text)
{
    const QString none, bar = QStringLiteral("_"), open = QStringLiteral("("),
                        close = QStringLiteral(")");
    return turned(text,
                  {{{QStringLiteral("bc"), QStringLiteral("ca"), QStringLiteral("ab")}, bar, none},
                   {{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}, bar, none},
                   {{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")}, open, close},
                   {{QStringLiteral("₀"), QStringLiteral("₁"), QStringLiteral("₂")}, none, none},
                   {{QStringLiteral("α"), QStringLiteral("β"), QStringLiteral("γ")}, none, none}});
}

/// Whether a name starts here, whatever change (Δ or δ) it may be of.
bool startsName(const QString &text, qsizetype place)
{
    const QChar before = place == 0 ? QChar(u' ') : text[place - 1];
    return before == u'Δ' || before == u'δ' || !belongsToName(before);
}

/// What is done to a coordinate along an edge, done to R: y₀₂ → R₀₂, m₀₂ → δR₀₂. The coordinate is
/// the first one that the text names. Conditions stay.
QString coordinateAsChannel(const QString &text)
{
    static const QRegularExpression firstCoordinate(QStringLiteral("[xy]"));
    const qsizetype first = text.indexOf(firstCoordinate);
    if (first < 0)
        return text;
    const QChar coordinate = text[first];
    QString result;
    bool isCondition = false;
    for (qsizetype place = 0; place < text.size(); ++place) {
        const QStringView rest = QStringView(text).sliced(place);
        isCondition = rest.startsWith(QStringLiteral(" if "))
            || (isCondition && !rest.startsWith(QStringLiteral(", else ")));
        const bool isTurned
            = !isCondition && startsName(text, place) && rest.size() > 1 && belongsToName(rest[1]);
        if (isTurned && rest[0] == u'm')
            result += QStringLiteral("δR");
        else
            result += isTurned && rest[0] == coordinate ? QChar(u'R') : rest[0];
    }
    return result;
}

/// The text with the next channel: R, R_a, R₀, ΔR_x; R after a coordinate.
QString nextChannel(const QString &text)
{
    if (QStringLiteral("xym").contains(text.front()))
        return coordinateAsChannel(text);
    const QString letters = QStringLiteral("RGB");
    QString result = text;
    for (qsizetype place = 0; place < text.size(); ++place) {
        const qsizetype channel = letters.indexOf(text[place]);
        if (channel >= 0 && startsName(text, place))
            result[place] = letters[(channel + 1) % 3];
    }
    return result;
}

/// Whether a name of the text begins with these letters.
bool hasName(const QString &text, const QString &letters)
{
    qsizetype place = text.indexOf(letters);
    while (place >= 0 && !startsName(text, place))
        place = text.indexOf(letters, place + 1);
    return place >= 0;
}

Number floorOf(const Number &value)
{
    const BigInteger top = numerator(value), bottom = denominator(value);
    const BigInteger whole = top / bottom; // towards 0
    return Number(top < 0 && whole * bottom != top ? BigInteger(whole - 1) : whole);
}

/// Reads an expression from left to right.
class Reader {
public:
    Reader(const QString &text, const ListingNames &names)
        : m_text(text)
        , m_names(names)
    {
    }

    Number result()
    {
        const Number value = sum();
        if (m_place != m_text.size())
            throw ListingFault(QStringLiteral("cannot read “%1”").arg(m_text));
        return value;
    }

private:
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
            if (takes(QStringLiteral(" + ")))
                value += product();
            else if (takes(QStringLiteral(" − ")))
                value -= product();
            else
                return value;
        }
    }
    Number product()
    {
        Number value = factor();
        for (;;) {
            if (takes(QStringLiteral("·"))) {
                value *= factor();
            } else if (takes(QStringLiteral("/"))) {
                const Number divisor = factor();
                if (divisor == 0)
                    throw ListingFault(QStringLiteral("divides by 0: ") + m_text);
                value /= divisor;
            } else {
                return value;
            }
        }
    }
    Number factor()
    {
        if (takes(QStringLiteral("−")))
            return -factor();
        if (takes(QStringLiteral("(int)("))) {
            const Number value = upTo(QStringLiteral(")"));
            return value < 0 ? -floorOf(-value) : floorOf(value);
        }
        if (takes(QStringLiteral("(")))
            return upTo(QStringLiteral(")"));
        if (takes(QStringLiteral("⌊")))
            return floorOf(upTo(QStringLiteral("⌋")));
        if (takes(QStringLiteral("⌈")))
            return -floorOf(-upTo(QStringLiteral("⌉")));
        if (takes(QStringLiteral("|"))) {
            const Number value = upTo(QStringLiteral("|"));
            return value < 0 ? Number(-value) : value;
        }
        if (takes(QStringLiteral("½")))
            return Number(1, 2);
        const qsizetype first = m_place;
        while (m_place < m_text.size() && m_text[m_place] >= u'0' && m_text[m_place] <= u'9')
            ++m_place;
        if (m_place == first)
            return named();
        Number value(m_text.sliced(first, m_place - first).toStdString());
        if (takes(QStringLiteral("²")))
            value *= value;
        // A number before a name multiplies: 2Δy
        return m_place < m_text.size() && m_text[m_place].isLetter() ? value * named() : value;
    }
    Number upTo(const QString &end)
    {
        const Number value = sum();
        if (!takes(end))
            throw ListingFault(QStringLiteral("not closed: ") + m_text);
        return value;
    }
    /// The longest name that starts here and ends at a word boundary.
    Number named()
    {
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
            throw ListingFault(
                QStringLiteral("no value of “%1” in: %2").arg(m_text.sliced(m_place), m_text));
        m_place += longest->first.size();
        return longest->second;
    }

    const QString &m_text;
    const ListingNames &m_names;
    qsizetype m_place = 0;
};

} // namespace

QStringList spelledOut(const QString &text)
{
    QStringList parts;
    for (const QString &part : text.split(QStringLiteral("; "))) {
        if (!part.endsWith(likewise)) {
            parts.append(part);
            continue;
        }
        if (parts.isEmpty())
            throw ListingFault(QStringLiteral("like what: ") + text);
        const QString pattern = parts.constLast();
        const QStringList names = part.chopped(likewise.size())
                                      .replace(QStringLiteral(" and "), QStringLiteral(", "))
                                      .split(QStringLiteral(", "));
        QString edge = pattern, channel = pattern;
        for (const QString &name : names) {
            edge = nextEdge(edge);
            channel = nextChannel(channel);
            const bool isEdge = edge != pattern && hasName(edge, name);
            if (!isEdge && (channel == pattern || !hasName(channel, name)))
                throw ListingFault(QStringLiteral("no “%1” in: %2").arg(name, text));
            parts.append(isEdge ? edge : channel);
        }
    }
    return parts;
}

BigRational valueOf(const QString &expression, const ListingNames &names)
{
    return Reader(expression, names).result();
}

} // namespace pixelplumb
