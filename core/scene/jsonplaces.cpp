// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/jsonplaces.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include <cctype>
#include <cstring>
#include <functional>
#include <vector>

namespace pixelplumb {

QString memberPath(const QString &parent, const QString &key)
{
    return parent.isEmpty() ? key : parent + u'.' + key;
}

QString elementPath(const QString &parent, qsizetype index)
{
    return parent + u'[' + QString::number(index) + u']';
}

namespace {

/// Walks the values of a text that QJsonDocument has accepted, so its depth is limited and nothing
/// but the structure has to be looked at. A visit that returns false ends the walk.
class JsonWalk {
public:
    using Visit = std::function<bool(const JsonWalk &walk)>;

    JsonWalk(const QByteArray &text, Visit visit)
        : m_text(text)
        , m_visit(std::move(visit))
    {
    }

    void run() { walkValue(); }

    /// Of the value in hand.
    qsizetype offset() const { return m_offset; }
    bool hasRepeatedKey() const { return m_repeatedKey; }
    QString path() const
    {
        QString path;
        for (const Step &step : m_steps)
            path = step.index < 0 ? memberPath(path, step.key) : elementPath(path, step.index);
        return path;
    }

private:
    struct Step {
        QString key;
        qsizetype index = -1; ///< of an array's element; −1 for an object's member
    };

    /// The next byte that is not layout; 0 at the end.
    char peek()
    {
        while (m_position < m_text.size()
               && std::isspace(static_cast<unsigned char>(m_text[m_position])))
            ++m_position;
        return m_position < m_text.size() ? m_text[m_position] : '\0';
    }
    bool take(char expected)
    {
        const bool found = peek() == expected;
        m_position += found ? 1 : 0;
        return found;
    }
    /// What it means: "w\u0069dth" is "width".
    QString takeString()
    {
        const qsizetype first = ++m_position;
        while (m_position < m_text.size() && m_text[m_position] != '"')
            m_position += m_text[m_position] == '\\' ? 2 : 1;
        const QByteArray written = m_text.sliced(first, m_position++ - first);
        if (!written.contains('\\'))
            return QString::fromUtf8(written);
        return QJsonDocument::fromJson("[\"" + written + "\"]").array().at(0).toString();
    }

    bool walkValue()
    {
        const char first = peek();
        m_offset = m_position;
        if (!m_visit(*this))
            return false;
        m_repeatedKey = false;
        if (first == '{')
            return walkObject();
        if (first == '[')
            return walkArray();
        if (first == '"')
            takeString();
        else
            m_position = endOfScalar();
        return true;
    }
    bool walkObject()
    {
        QSet<QString> keys;
        for (take('{'); !take('}'); take(',')) {
            if (peek() != '"')
                return false;
            m_steps.push_back({takeString(), -1});
            m_repeatedKey = keys.contains(m_steps.back().key);
            keys.insert(m_steps.back().key);
            take(':');
            if (!walkValue())
                return false;
            m_steps.pop_back();
        }
        return true;
    }
    bool walkArray()
    {
        m_steps.push_back({{}, 0});
        for (take('['); !take(']'); take(',')) {
            if (peek() == '\0' || !walkValue())
                return false;
            ++m_steps.back().index;
        }
        m_steps.pop_back();
        return true;
    }
    qsizetype endOfScalar() const
    {
        qsizetype end = m_position;
        while (end < m_text.size() && std::strchr(",]} \t\r\n", m_text[end]) == nullptr)
            ++end;
        return end;
    }

    const QByteArray &m_text;
    Visit m_visit;
    std::vector<Step> m_steps;
    qsizetype m_position = 0;
    qsizetype m_offset = 0;
    bool m_repeatedKey = false;
};

} // namespace

QString linePlace(const QByteArray &text, qsizetype offset)
{
    const QByteArray before = text.first(qBound(qsizetype(0), offset, text.size()));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    return QStringLiteral("line %1, column %2")
        .arg(before.count('\n') + 1)
        .arg(QString::fromUtf8(before.sliced(lineStart)).size() + 1);
}

std::optional<qsizetype> offsetOfJsonValue(const QByteArray &text, const QString &path)
{
    std::optional<qsizetype> offset;
    JsonWalk(text, [&](const JsonWalk &walk) {
        if (walk.path() == path)
            offset = walk.offset();
        return !offset;
    }).run();
    return offset;
}

std::optional<RepeatedJsonKey> repeatedJsonKey(const QByteArray &text)
{
    std::optional<RepeatedJsonKey> repeated;
    JsonWalk(text, [&](const JsonWalk &walk) {
        if (walk.hasRepeatedKey())
            repeated = RepeatedJsonKey{walk.path(), walk.offset()};
        return !repeated;
    }).run();
    return repeated;
}

} // namespace pixelplumb
