// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/jsonsyntax.h"

#include "core/scene/jsonplaces.h"

#include <QByteArrayView>

#include <cctype>
#include <vector>

namespace pixelplumb {

namespace {

constexpr std::size_t deepestNesting = 1024; // as QJsonDocument

class SyntaxWalk {
public:
    explicit SyntaxWalk(QByteArrayView text)
        : m_text(text)
    {
    }

    qsizetype position() const { return m_position; }
    /// What should stand at position(); empty where the whole text is JSON.
    QString missing()
    {
        if (!takeValue())
            return m_missing;
        while (!m_open.empty()) {
            if (!takeAfterValue())
                return m_missing;
        }
        return peek() == '\0' && m_position == m_text.size() ? QString()
                                                             : QStringLiteral("the text's end");
    }

private:
    char peek()
    {
        while (m_position < m_text.size() && QByteArrayView(" \t\r\n").contains(m_text[m_position]))
            ++m_position;
        return m_position < m_text.size() ? m_text[m_position] : '\0';
    }
    bool isAt(char expected) const
    {
        return m_position < m_text.size() && m_text[m_position] == expected;
    }
    bool lacks(const QString &what)
    {
        m_missing = what;
        return false;
    }
    bool take(char expected)
    {
        if (peek() != expected)
            return lacks(QStringLiteral("“%1”").arg(QChar::fromLatin1(expected)));
        ++m_position;
        return true;
    }

    /// What follows a value inside of an array or an object: its end, or the next value.
    bool takeAfterValue()
    {
        const char closing = m_open.back() == '{' ? '}' : ']';
        if (peek() == closing) {
            ++m_position;
            m_open.pop_back();
            return true;
        }
        if (peek() != ',')
            return lacks(QStringLiteral("“,” or “%1”").arg(QChar::fromLatin1(closing)));
        ++m_position;
        return (closing == ']' || takeKey()) && takeValue();
    }
    bool takeKey()
    {
        if (peek() != '"')
            return lacks(QStringLiteral("a key in quotation marks"));
        return takeString() && take(':');
    }
    /// A scalar, an empty array or object, or the beginning of one with its first values.
    bool takeValue()
    {
        while (true) {
            const char first = peek();
            if (first == '"')
                return takeString();
            if (first != '[' && first != '{')
                return takeScalar();
            if (m_open.size() >= deepestNesting)
                return lacks(QStringLiteral("at most %1 levels").arg(deepestNesting));
            ++m_position;
            if (peek() == (first == '{' ? '}' : ']')) {
                ++m_position;
                return true;
            }
            m_open.push_back(first);
            if (first == '{' && !takeKey())
                return false;
        }
    }
    bool takeString()
    {
        for (++m_position; m_position < m_text.size() && !isAt('"'); ++m_position) {
            if (static_cast<unsigned char>(m_text[m_position]) < ' ')
                return lacks(QStringLiteral("the end of a string"));
            if (isAt('\\') && !takeEscape())
                return false;
        }
        if (!isAt('"'))
            return lacks(QStringLiteral("the end of a string"));
        ++m_position;
        return true;
    }
    /// Leaves the last character of the escape in hand.
    bool takeEscape()
    {
        ++m_position;
        if (m_position >= m_text.size()
            || !QByteArrayView("\"\\/bfnrtu").contains(m_text[m_position]))
            return lacks(QStringLiteral("one of \" \\ / b f n r t u"));
        for (int digits = isAt('u') ? 4 : 0; digits > 0; --digits) {
            ++m_position;
            if (m_position >= m_text.size()
                || !std::isxdigit(static_cast<unsigned char>(m_text[m_position])))
                return lacks(QStringLiteral("four hexadecimal digits"));
        }
        return true;
    }
    bool takeScalar()
    {
        for (const QByteArrayView word : {"true", "false", "null"}) {
            if (m_text.sliced(m_position).startsWith(word)) {
                m_position += word.size();
                return true;
            }
        }
        return takeNumber();
    }
    bool takeNumber()
    {
        if (isAt('-'))
            ++m_position;
        if (isAt('0')) // stands alone before the point
            ++m_position;
        else if (!takeDigits())
            return lacks(QStringLiteral("a value"));
        if (isAt('.')) {
            ++m_position;
            if (!takeDigits())
                return lacks(QStringLiteral("a digit"));
        }
        if (isAt('e') || isAt('E')) {
            ++m_position;
            if (isAt('+') || isAt('-'))
                ++m_position;
            if (!takeDigits())
                return lacks(QStringLiteral("a digit"));
        }
        return true;
    }
    bool takeDigits()
    {
        const qsizetype first = m_position;
        while (m_position < m_text.size()
               && std::isdigit(static_cast<unsigned char>(m_text[m_position])))
            ++m_position;
        return m_position > first;
    }

    QByteArrayView m_text;
    qsizetype m_position = 0;
    std::vector<char> m_open; ///< the brackets that are open
    QString m_missing;
};

} // namespace

std::optional<InputError> jsonSyntaxError(const QByteArray &text)
{
    SyntaxWalk walk(text);
    const QString missing = walk.missing();
    if (missing.isEmpty())
        return std::nullopt;
    const qsizetype place = std::min(walk.position(), text.size());
    const QString found = place == text.size()
        ? QStringLiteral("the text ends")
        : QStringLiteral("“%1”").arg(QString::fromUtf8(text.mid(place, 12)).left(8).simplified());
    return InputError{linePlace(text, place), found, missing};
}

} // namespace pixelplumb
