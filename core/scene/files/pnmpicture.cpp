// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/pnmpicture.h"

#include <QtEndian>

#include <algorithm>
#include <cctype>
#include <optional>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// Reads words one by one; # begins a comment up to the end of its line.
class WordReader {
public:
    explicit WordReader(QByteArrayView content, qsizetype place = 0, int line = 1)
        : m_content(content)
        , m_place(place)
        , m_line(line)
    {
    }

    /// None at the end of the content.
    std::optional<QByteArrayView> next()
    {
        while (m_place < m_content.size() && (isSpace() || m_content[m_place] == '#')) {
            if (m_content[m_place] == '#')
                skipLine();
            else
                m_line += m_content[m_place++] == '\n' ? 1 : 0;
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
    void skipLine()
    {
        while (m_place < m_content.size() && m_content[m_place] != '\n')
            ++m_place;
    }

    QByteArrayView m_content;
    qsizetype m_place;
    int m_line;
};

} // namespace

bool PnmPicture::isPnm(const QByteArray &content)
{
    return content.size() > 2 && content[0] == 'P' && content[1] >= '1' && content[1] <= '6'
        && QByteArrayView(" \t\r\n#").contains(content[2]);
}

PnmPicture::PnmPicture(const QByteArray &content)
    : m_content(content)
    , m_digit(content[1])
{
    WordReader words(m_content);
    words.next();
    const auto take = [&](const char *name, int &number) {
        constexpr int most = 65535; // for a side or a level
        if (!m_fault.isEmpty())
            return;
        const auto word = words.next();
        bool isNumber = false;
        number = word ? word->toInt(&isNumber) : 0;
        if (!word)
            m_fault = u"a %1 that ends early, in its header: it has no %2"_s.arg(
                kind(), QLatin1String(name));
        else if (!isNumber || number < 1 || number > most)
            m_fault = u"a broken %1: line %2: “%3” is no %4 from 1 to %5"_s.arg(
                kind(), QString::number(words.line()),
                QString::fromLatin1(word->first(std::min<qsizetype>(20, word->size()))),
                QLatin1String(name), QString::number(most));
    };
    take("width", m_width);
    take("height", m_height);
    if (!isBitmap())
        take("greatest level", m_greatest);
    m_headersEnd = words.place();
    m_line = words.line();
}

QByteArray PnmPicture::format() const { return isBitmap() ? "pbm" : hasColours() ? "ppm" : "pgm"; }

/// Each line of bits is padded to whole bytes.
qint64 PnmPicture::bytesOfLine() const
{
    constexpr int greatestByte = 255;
    return isBitmap() ? (qint64(m_width) + 7) / 8
                      : levelsOfLine() * (m_greatest > greatestByte ? 2 : 1);
}

void PnmPicture::keepMissing(qint64 found, qint64 needed, const char *what)
{
    m_fault = u"a %1 that ends early, %2 of %3 %4 are missing"_s.arg(
        kind(), QString::number(needed - found), QString::number(needed), QLatin1String(what));
}

QImage PnmPicture::read()
{
    if (!m_fault.isEmpty())
        return {};
    QImage picture(size(), QImage::Format_RGB32);
    if (picture.isNull())
        m_fault = u"no memory for its pixels"_s;
    else if (isText())
        readText(picture);
    else
        readBinary(picture);
    return m_fault.isEmpty() ? picture : QImage();
}

/// next(line, place): the level at a place of a line; below 0 ends the reading.
template <class Next>
void PnmPicture::readLevels(const Next &next, QImage &picture)
{
    const auto byteOf = [this](int level) {
        return isBitmap() ? 255 * (1 - level) : (510 * level + m_greatest) / (2 * m_greatest);
    };
    const int channels = hasColours() ? 3 : 1;
    for (int line = 0; line < m_height; ++line) {
        auto *pixels = reinterpret_cast<QRgb *>(picture.scanLine(line));
        for (int x = 0; x < m_width; ++x) {
            std::array<int, 3> bytes = {};
            for (int channel = 0; channel < channels; ++channel) {
                const int level = next(line, qint64(x) * channels + channel);
                if (level < 0)
                    return;
                bytes[std::size_t(channel)] = byteOf(level);
            }
            pixels[x] = hasColours() ? qRgb(bytes[0], bytes[1], bytes[2])
                                     : qRgb(bytes[0], bytes[0], bytes[0]);
        }
    }
}

/// The bits of a bitmap may stand without spaces between them. What follows the last level must be
/// levels, too.
void PnmPicture::readText(QImage &picture)
{
    WordReader words(m_content, m_headersEnd, m_line);
    QByteArrayView bits; // of a bitmap's word, which are still to be read
    const auto nextLevel = [&]() -> std::optional<int> {
        if (bits.isEmpty()) {
            const auto word = words.next();
            if (!word)
                return std::nullopt;
            bits = *word;
        }
        bool isNumber = false;
        const qsizetype taken = isBitmap() ? 1 : bits.size();
        const int level = bits.first(taken).toInt(&isNumber);
        bits = bits.sliced(taken);
        if (isNumber && level >= 0 && level <= m_greatest)
            return level;
        m_fault = u"line %1: no level from 0 to %2"_s.arg(words.line()).arg(m_greatest);
        return std::nullopt;
    };
    const qint64 needed = levelsOfLine() * m_height;
    qint64 found = 0;
    readLevels(
        [&](int, qint64) {
            const auto level = nextLevel();
            found += level ? 1 : 0;
            return level.value_or(-1);
        },
        picture);
    while (nextLevel()) { }
    if (m_fault.isEmpty() && found < needed)
        keepMissing(found, needed, "levels");
}

void PnmPicture::readBinary(QImage &picture)
{
    // Exactly one space precedes the pixels.
    const QByteArrayView pixels
        = QByteArrayView(m_content).sliced(std::min(m_headersEnd + 1, m_content.size()));
    const qint64 needed = bytesOfLine() * m_height;
    if (pixels.size() < needed) {
        keepMissing(pixels.size(), needed, "bytes of pixels");
        return;
    }
    readLevels(
        [&](int line, qint64 place) {
            const auto *bytes
                = reinterpret_cast<const uchar *>(pixels.data()) + line * bytesOfLine();
            if (isBitmap())
                return bytes[place / 8] >> (7 - place % 8) & 1;
            const int level = bytesOfLine() > levelsOfLine()
                ? int(qFromBigEndian<quint16>(bytes + 2 * place))
                : int(bytes[place]);
            if (level <= m_greatest)
                return level;
            m_fault = u"a broken %1: a level of %2 in line %3 of its pixels; its "
                      "header says %4 at most"_s.arg(kind(), QString::number(level),
                                                     QString::number(line + 1),
                                                     QString::number(m_greatest));
            return -1;
        },
        picture);
}

} // namespace pixelplumb
