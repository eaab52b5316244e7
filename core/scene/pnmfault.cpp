// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pnmfault.h"

#include <cctype>
#include <optional>

namespace pixelplumb {

namespace {

/// Reads words one by one; a # begins a comment that goes to the end of its line.
class WordReader {
public:
    explicit WordReader(const QByteArray &content)
        : m_content(content)
    {
    }

    /// None at the end.
    std::optional<QByteArray> next()
    {
        while (m_place < m_content.size() && (isSpace() || m_content[m_place] == '#')) {
            if (m_content[m_place] == '#')
                skipLine();
            else
                skipOne();
        }
        const qsizetype first = m_place;
        while (m_place < m_content.size() && !isSpace() && m_content[m_place] != '#')
            ++m_place;
        if (m_place == first)
            return std::nullopt;
        return m_content.sliced(first, m_place - first);
    }
    int line() const { return m_line; } ///< of the last word, from 1

private:
    bool isSpace() const
    {
        return std::isspace(static_cast<unsigned char>(m_content[m_place])) != 0;
    }
    void skipOne() { m_line += m_content[m_place++] == '\n' ? 1 : 0; }
    void skipLine()
    {
        while (m_place < m_content.size() && m_content[m_place] != '\n')
            ++m_place;
    }

    const QByteArray &m_content;
    qsizetype m_place = 0;
    int m_line = 1;
};

} // namespace

QString pnmFault(const QByteArray &content)
{
    WordReader reader(content);
    const auto kind = reader.next();
    if (kind != "P2" && kind != "P3")
        return {};
    int greatest = 0;
    for (int i = 0; i < 3; ++i) // width, height, greatest level
        greatest = reader.next().value_or(QByteArray()).toInt();
    while (const auto word = reader.next()) {
        bool isNumber = false;
        const int level = word->toInt(&isNumber);
        if (!isNumber || level < 0 || level > greatest)
            return QStringLiteral("line %1: no level from 0 to %2")
                .arg(reader.line())
                .arg(greatest);
    }
    return {};
}

} // namespace pixelplumb
