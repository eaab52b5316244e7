// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/pngfault.h"

#include "core/frame/framespec.h"
#include "core/scene/files/pngheader.h"
#include "core/scene/text/inflated.h"

#include <QtEndian>

#include <boost/crc.hpp>

#include <algorithm>

namespace pixelplumb {

namespace {

using ColourType = PngHeader::ColourType;

constexpr QByteArrayView signature("\x89PNG\r\n\x1a\n");
constexpr qsizetype frameOfChunk = 12; // length, type and checksum

/// The cyclic redundancy check of ISO/IEC 15948, annex D.
std::uint32_t checksumOf(QByteArrayView bytes)
{
    boost::crc_32_type check;
    check.process_bytes(bytes.data(), std::size_t(bytes.size()));
    return check.checksum();
}

/// Critical chunks begin with a capital: bit 5 is not set.
bool isCritical(QByteArrayView type) { return (std::uint8_t(type.front()) & 0x20U) == 0; }

bool isName(QByteArrayView type)
{
    return std::ranges::all_of(type, [](char letter) {
        return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
    });
}

/// A damaged file may have any bytes as a type.
QString typeText(QByteArrayView type)
{
    return isName(type) ? QString::fromLatin1(type) : QStringLiteral("a chunk");
}

/// The chunks that the pixels need, in file order; views of the file.
struct PngParts {
    QByteArrayView headerChunk;
    PngHeader header;
    QByteArrayView palette; ///< empty: none
    QByteArrayView transparency;
    QByteArray pixels; ///< joined from all their chunks
};

/// A palette has red, green and blue for each colour.
QString paletteFault(QByteArrayView palette, const PngParts &parts)
{
    constexpr qsizetype bytesOfColour = 3;
    if (!parts.palette.isEmpty())
        return QStringLiteral("it has two palettes (PLTE)");
    const qsizetype most
        = parts.header.colourType == ColourType::Palette ? qsizetype(1) << parts.header.depth : 256;
    const qsizetype colours = palette.size() / bytesOfColour;
    if (palette.size() % bytesOfColour == 0 && colours >= 1 && colours <= most)
        return {};
    return QStringLiteral("its palette (PLTE) has %1 bytes").arg(palette.size());
}

/// Checks the first chunk of pixels: what is missing before it, and whether it is compressed in
/// another way (RFC 1950, 2.2).
QString firstPixelsFault(QByteArrayView pixels, const PngParts &parts)
{
    if (parts.header.colourType == ColourType::Palette && parts.palette.isEmpty())
        return QStringLiteral("its palette (PLTE) is missing");
    constexpr int deflate = 8;
    if (pixels.size() < 2) // the rest is in the next chunk
        return {};
    const auto first = std::uint8_t(pixels[0]);
    const bool isDeflated
        = (first & 0x0fU) == deflate && (first * 256 + std::uint8_t(pixels[1])) % 31 == 0;
    return isDeflated ? QString() : QStringLiteral("its pixels (IDAT) are not deflated");
}

/// Takes a chunk after the header; returns what is wrong with it, or empty.
QString takeChunk(QByteArrayView type, QByteArrayView content, PngParts &parts)
{
    if (type == "IDAT") {
        const QString fault = parts.pixels.isEmpty() ? firstPixelsFault(content, parts) : QString();
        parts.pixels += content;
        return fault;
    }
    if (type == "PLTE") {
        const QString fault = paletteFault(content, parts);
        parts.palette = content;
        return fault;
    }
    // Elsewhere tRNS is ignored (5.6).
    const bool isInPlace = parts.pixels.isEmpty()
        && (parts.header.colourType != ColourType::Palette || !parts.palette.isEmpty());
    if (type == "tRNS" && isInPlace && parts.transparency.isEmpty())
        parts.transparency = content;
    else if (isCritical(type) && type != "IEND")
        return QStringLiteral("%1 stands where there is no such chunk").arg(typeText(type));
    return {};
}

/// Checks the lines of pixels as they are inflated.
class LineCheck {
public:
    explicit LineCheck(const PngHeader &header)
        : m_lines(linesOf(header))
    {
        for (const PngLines &each : m_lines)
            m_needed += each.bytes * each.count;
    }

    /// False at a fault, and when there is far more than the pixels need.
    bool take(std::span<const std::uint8_t> block)
    {
        constexpr std::uint64_t mostBeyond = std::uint64_t(1) << 16;
        m_bytes += block.size();
        while (!block.empty() && m_pass < m_lines.size()) {
            constexpr std::uint8_t lastFilter = 4;
            if (m_inLine == 0 && block.front() > lastFilter) {
                m_hasUnknownFilter = true;
                return false;
            }
            const PngLines &lines = m_lines[m_pass];
            const std::uint64_t step
                = std::min<std::uint64_t>(lines.bytes - m_inLine, block.size());
            block = block.subspan(step);
            m_inLine += step;
            if (m_inLine < lines.bytes)
                continue;
            m_inLine = 0;
            if (++m_line == lines.count) {
                m_line = 0;
                ++m_pass;
            }
        }
        return m_bytes <= m_needed + mostBeyond;
    }

    QString fault(StreamEnd end) const
    {
        if (m_hasUnknownFilter)
            return QStringLiteral("a line of its pixels (IDAT) has a filter that is none");
        if (m_bytes < m_needed)
            return QStringLiteral("its pixels (IDAT) end early, at byte %1 of %2")
                .arg(m_bytes)
                .arg(m_needed);
        if (end == StreamEnd::Stopped)
            return QStringLiteral("its pixels (IDAT) go on behind the last line");
        return end == StreamEnd::Whole
            ? QString()
            : QStringLiteral("the checksum of its pixels (IDAT) is wrong");
    }

private:
    std::vector<PngLines> m_lines;
    std::uint64_t m_needed = 0; ///< bytes in total
    std::uint64_t m_bytes = 0;
    std::size_t m_pass = 0;
    std::uint64_t m_line = 0; ///< within the pass
    std::uint64_t m_inLine = 0; ///< bytes
    bool m_hasUnknownFilter = false;
};

QString pixelsFault(const PngParts &parts)
{
    if (parts.pixels.isEmpty())
        return QStringLiteral("it has no pixels (IDAT)");
    if (parts.header.area() > std::uint64_t(largestFrameArea)) // refused anyway
        return {};
    LineCheck check(parts.header);
    const StreamEnd end = inflate(
        parts.pixels, [&check](std::span<const std::uint8_t> block) { return check.take(block); });
    return check.fault(end);
}

QString broken(const QString &fault)
{
    return fault.isEmpty() ? fault : QStringLiteral("a broken PNG: ") + fault;
}

/// Takes the chunks of a file up to its end; returns what is wrong with them, or empty.
QString takeChunks(const QByteArray &content, PngParts &parts)
{
    for (qsizetype at = signature.size();;) {
        const qsizetype left = content.size() - at;
        if (left < frameOfChunk)
            return QStringLiteral("a PNG that ends early, at byte %1").arg(content.size());
        const auto length = qFromBigEndian<quint32>(content.constData() + at);
        const QByteArrayView type = QByteArrayView(content).sliced(at + 4, 4);
        if (length > quint64(left - frameOfChunk))
            return QStringLiteral("a PNG that ends early, in %1 at byte %2")
                .arg(typeText(type), QString::number(at));
        const QByteArrayView checked
            = QByteArrayView(content).sliced(at + 4, 4 + qsizetype(length));
        const auto checksum
            = qFromBigEndian<quint32>(content.constData() + at + 8 + qsizetype(length));
        if (isCritical(type) && checksumOf(checked) != checksum)
            return broken(QStringLiteral("the checksum of %1 at byte %2 is wrong")
                              .arg(typeText(type), QString::number(at)));
        const QByteArrayView chunk = checked.sliced(4);
        QString fault;
        if (!parts.headerChunk.isEmpty()) {
            fault = takeChunk(type, chunk, parts);
        } else if (type != "IHDR") {
            fault = QStringLiteral("it does not begin with its header (IHDR)");
        } else {
            fault = readPngHeader(chunk, parts.header);
            parts.headerChunk = chunk;
        }
        if (!fault.isEmpty() || type == "IEND")
            return broken(fault);
        at += frameOfChunk + qsizetype(length);
    }
}

/// Whether the decoder can use the tRNS chunk (11.3.2).
bool isTransparencyOf(QByteArrayView transparency, const PngParts &parts)
{
    constexpr qsizetype bytesOfSample = 2, bytesOfColour = 3;
    switch (parts.header.colourType) {
    case ColourType::Grey:
        return transparency.size() == bytesOfSample;
    case ColourType::Rgb:
        return transparency.size() == bytesOfColour * bytesOfSample;
    case ColourType::Palette:
        return transparency.size() >= 1
            && transparency.size() <= parts.palette.size() / bytesOfColour;
    case ColourType::GreyAlpha:
    case ColourType::Rgba:
        break;
    }
    return false;
}

void append(QByteArray &png, QByteArrayView type, QByteArrayView content)
{
    const auto number = [&png](std::uint32_t value) {
        const quint32 bytes = qToBigEndian(value);
        png.append(reinterpret_cast<const char *>(&bytes), sizeof bytes);
    };
    number(std::uint32_t(content.size()));
    const qsizetype checked = png.size();
    png.append(type).append(content);
    number(checksumOf(QByteArrayView(png).sliced(checked)));
}

} // namespace

QString pngFault(const QByteArray &content)
{
    if (!content.startsWith(signature))
        return {};
    PngParts parts;
    const QString fault = takeChunks(content, parts);
    return fault.isEmpty() ? broken(pixelsFault(parts)) : fault;
}

QByteArray plainPng(const QByteArray &content)
{
    PngParts parts;
    if (!content.startsWith(signature) || !takeChunks(content, parts).isEmpty())
        return content;
    QByteArray png = signature.toByteArray();
    append(png, "IHDR", parts.headerChunk);
    if (parts.header.colourType == ColourType::Palette)
        append(png, "PLTE", parts.palette);
    if (isTransparencyOf(parts.transparency, parts))
        append(png, "tRNS", parts.transparency);
    append(png, "IDAT", parts.pixels);
    append(png, "IEND", {});
    return png;
}

} // namespace pixelplumb
