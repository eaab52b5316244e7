// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/pnmfault.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace pixelplumb {

namespace {

/// Reads words one by one; # begins a comment up to the end of its line.
class WordReader {
public:
    explicit WordReader(const QByteArray &content)
        : m_content(content)
    {
    }

    /// None at the end of the content.
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
    qsizetype place() const { return m_place; } ///< just after the last word

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

bool isPnm(const QByteArray &content)
{
    return content.size() > 2 && content[0] == 'P' && content[1] >= '1' && content[1] <= '6'
        && QByteArrayView(" \t\r\n#").contains(content[2]);
}

/// The header's content; levels run from 0 to the greatest.
struct PnmHeader {
    char digit = '1'; ///< of P1 … P6
    int width = 0;
    int height = 0;
    int greatest = 1;

    bool isText() const { return digit <= '3'; }
    bool isBitmap() const { return digit == '1' || digit == '4'; }
    bool hasColours() const { return digit == '3' || digit == '6'; }
    QString kind() const
    {
        return isBitmap() ? QStringLiteral("PBM")
                          : (hasColours() ? QStringLiteral("PPM") : QStringLiteral("PGM"));
    }
    qint64 levels() const { return qint64(width) * height * (hasColours() ? 3 : 1); }
    /// The size of binary pixels; each line of bits is padded to whole bytes.
    qint64 bytes() const
    {
        constexpr int greatestByte = 255;
        return isBitmap() ? (qint64(width) + 7) / 8 * height
                          : levels() * (greatest > greatestByte ? 2 : 1);
    }
};

/// Reads the header after its P and digit; returns what is wrong with it, or empty.
QString headerFault(WordReader &reader, PnmHeader &header)
{
    constexpr int most = 65535; // for a side or a level
    const auto take = [&](const char *name, int &number) -> QString {
        const auto word = reader.next();
        if (!word)
            return QStringLiteral("a %1 that ends early, in its header: it has no %2")
                .arg(header.kind(), QLatin1String(name));
        bool isNumber = false;
        number = word->toInt(&isNumber);
        if (isNumber && number >= 1 && number <= most)
            return {};
        constexpr int longestShown = 20;
        return QStringLiteral("a broken %1: line %2: “%3” is no %4 from 1 to %5")
            .arg(header.kind(), QString::number(reader.line()),
                 QString::fromLatin1(word->left(longestShown)), QLatin1String(name),
                 QString::number(most));
    };
    if (const QString fault = take("width", header.width); !fault.isEmpty())
        return fault;
    if (const QString fault = take("height", header.height); !fault.isEmpty())
        return fault;
    return header.isBitmap() ? QString() : take("greatest level", header.greatest);
}

QString missingText(const PnmHeader &header, qint64 found, qint64 needed, const char *what)
{
    if (found >= needed)
        return {};
    return QStringLiteral("a %1 that ends early, %2 of %3 %4 are missing")
        .arg(header.kind(), QString::number(needed - found), QString::number(needed),
             QLatin1String(what));
}

/// The bits of a bitmap may stand without spaces between them.
QString levelsFault(WordReader &reader, const PnmHeader &header)
{
    qint64 found = 0;
    while (const auto word = reader.next()) {
        bool isNumber = false;
        const int level = word->toInt(&isNumber);
        const bool isBits = word->count('0') + word->count('1') == word->size();
        if (header.isBitmap() ? !isBits : !isNumber || level < 0 || level > header.greatest)
            return QStringLiteral("line %1: no level from 0 to %2")
                .arg(reader.line())
                .arg(header.greatest);
        found += header.isBitmap() ? word->size() : 1;
    }
    return missingText(header, found, header.levels(), "levels");
}

} // namespace

QString pnmFault(const QByteArray &content)
{
    if (!isPnm(content))
        return {};
    WordReader reader(content);
    reader.next();
    PnmHeader header{content[1]};
    if (const QString fault = headerFault(reader, header); !fault.isEmpty())
        return fault;
    if (header.isText())
        return levelsFault(reader, header);
    // Exactly one space precedes the pixels.
    const qint64 found = std::max<qint64>(0, content.size() - reader.place() - 1);
    return missingText(header, found, header.bytes(), "bytes of pixels");
}

QByteArray withSpacedBits(const QByteArray &content)
{
    if (!isPnm(content) || content[1] != '1')
        return content;
    WordReader reader(content);
    QByteArray spaced;
    int word = 0;
    while (const auto next = reader.next()) {
        constexpr int headerWords = 3; // P1, width, height
        if (word++ < headerWords) {
            spaced += *next + '\n';
            continue;
        }
        for (const char bit : *next) {
            spaced += bit;
            spaced += ' ';
        }
    }
    return spaced;
}

} // namespace pixelplumb
