// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pngfault.h"

#include <QtEndian>

#include <boost/crc.hpp>

#include <algorithm>
#include <optional>

namespace pixelplumb {

namespace {

constexpr qsizetype signatureSize = 8;
constexpr qsizetype frameOfChunk = 12; // length, type and checksum

/// The cyclic redundancy check of ISO/IEC 15948, annex D.
std::uint32_t checksumOf(QByteArrayView bytes)
{
    boost::crc_32_type check;
    check.process_bytes(bytes.data(), std::size_t(bytes.size()));
    return check.checksum();
}

/// Critical chunks have a capital first: bit 5 is not set.
bool isCritical(QByteArrayView type) { return (std::uint8_t(type.front()) & 0x20U) == 0; }

/// A damaged file may have anything for a type.
QString typeText(QByteArrayView type)
{
    const bool isName = std::ranges::all_of(type, [](char letter) {
        return (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
    });
    return isName ? QString::fromLatin1(type) : QStringLiteral("a chunk");
}

/// Of ISO/IEC 15948, 11.2.2: the depths in bits that a colour type can have; none: it is no type.
QByteArrayView depthsOf(char colourType)
{
    switch (colourType) {
    case 0:
        return "\x01\x02\x04\x08\x10";
    case 3:
        return "\x01\x02\x04\x08";
    case 2:
    case 4:
    case 6:
        return "\x08\x10";
    default:
        return {};
    }
}

constexpr qsizetype depthPlace = 8; // in IHDR
constexpr qsizetype typePlace = 9;
constexpr char paletteType = 3;

/// What is wrong with the content of IHDR, which comes first.
QString headerFault(QByteArrayView header)
{
    constexpr qsizetype headerSize = 13;
    if (header.size() != headerSize)
        return QStringLiteral("a broken PNG: its header has %1 bytes in place of 13")
            .arg(header.size());
    if (depthsOf(header[typePlace]).contains(header[depthPlace]))
        return {};
    return QStringLiteral("a broken PNG: its header says colour type %1 of %2 bits, which is none")
        .arg(int(std::uint8_t(header[typePlace])))
        .arg(int(std::uint8_t(header[depthPlace])));
}

/// Of the first chunk of pixels: what is missing before it, or whether they are compressed
/// otherwise (RFC 1950, 2.2).
QString pixelsFault(QByteArrayView pixels, char colourType, bool hasPalette)
{
    if (colourType == paletteType && !hasPalette)
        return QStringLiteral("a broken PNG: its palette (PLTE) is missing");
    constexpr int deflate = 8;
    if (pixels.size() < 2) // the others are in the next chunk
        return {};
    const auto first = std::uint8_t(pixels[0]);
    const bool isDeflated
        = (first & 0x0fU) == deflate && (first * 256 + std::uint8_t(pixels[1])) % 31 == 0;
    return isDeflated ? QString()
                      : QStringLiteral("a broken PNG: its pixels (IDAT) are not deflated");
}

} // namespace

QString pngFault(const QByteArray &content)
{
    if (!content.startsWith("\x89PNG\r\n\x1a\n"))
        return {};
    std::optional<char> colourType;
    bool hasPalette = false;
    bool hasPixels = false;
    for (qsizetype at = signatureSize;;) {
        const qsizetype left = content.size() - at;
        if (left < frameOfChunk)
            return QStringLiteral("a PNG that ends early, at byte %1").arg(content.size());
        const auto length = qFromBigEndian<quint32>(content.constData() + at);
        const QByteArrayView type = QByteArrayView(content).sliced(at + 4, 4);
        if (length > quint64(left - frameOfChunk))
            return QStringLiteral("a PNG that ends early, in %1 at byte %2")
                .arg(typeText(type))
                .arg(at);
        const QByteArrayView checked
            = QByteArrayView(content).sliced(at + 4, 4 + qsizetype(length));
        const auto checksum
            = qFromBigEndian<quint32>(content.constData() + at + 8 + qsizetype(length));
        if (isCritical(type) && checksumOf(checked) != checksum)
            return QStringLiteral("a broken PNG: the checksum of %1 at byte %2 is wrong")
                .arg(typeText(type))
                .arg(at);
        const QByteArrayView chunk = checked.sliced(4);
        QString fault;
        if (!colourType) {
            if (type != "IHDR")
                return QStringLiteral("a broken PNG: it does not begin with its header (IHDR)");
            fault = headerFault(chunk);
            colourType = fault.isEmpty() ? chunk[typePlace] : char();
        } else if (type == "IDAT" && !hasPixels) {
            fault = pixelsFault(chunk, *colourType, hasPalette);
            hasPixels = true;
        }
        hasPalette = hasPalette || type == "PLTE";
        if (!fault.isEmpty())
            return fault;
        if (type == "IEND")
            return hasPixels ? QString() : QStringLiteral("a broken PNG: it has no pixels (IDAT)");
        at += frameOfChunk + qsizetype(length);
    }
}

} // namespace pixelplumb
