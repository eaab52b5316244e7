// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/pngfault.h"

#include "core/frame/framespec.h"
#include "core/scene/inflated.h"

#include <QtEndian>

#include <boost/crc.hpp>

#include <algorithm>
#include <array>
#include <utility>

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

constexpr qsizetype heightPlace = 4; // in IHDR, behind the width
constexpr qsizetype depthPlace = 8;
constexpr qsizetype typePlace = 9;
constexpr qsizetype interlacingPlace = 12;
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

std::uint64_t samplesOfPixel(char colourType)
{
    switch (colourType) {
    case 2:
        return 3;
    case 4:
        return 2;
    case 6:
        return 4;
    default:
        return 1;
    }
}

/// Pixels of every so manieth column and line from one on.
struct InterlacedPass {
    std::uint64_t firstColumn, firstLine, columns, lines;
};
constexpr InterlacedPass wholePass = {0, 0, 1, 1};
/// Adam7, ISO/IEC 15948, 8.2.
constexpr std::array interlacedPasses
    = {InterlacedPass{0, 0, 8, 8}, InterlacedPass{4, 0, 8, 8}, InterlacedPass{0, 4, 4, 8},
       InterlacedPass{2, 0, 4, 4}, InterlacedPass{0, 2, 2, 4}, InterlacedPass{1, 0, 2, 2},
       InterlacedPass{0, 1, 1, 2}};

/// Width and height, px.
std::pair<std::uint64_t, std::uint64_t> sidesOf(QByteArrayView header)
{
    return {qFromBigEndian<quint32>(header.data()),
            qFromBigEndian<quint32>(header.data() + heightPlace)};
}

/// What the pixels of a picture with this header take before they are compressed.
std::uint64_t bytesOfPixels(QByteArrayView header)
{
    const auto sides = sidesOf(header);
    const std::uint64_t bits = std::uint8_t(header[depthPlace]) * samplesOfPixel(header[typePlace]);
    const auto bytesOf = [&](const InterlacedPass &pass) -> std::uint64_t {
        const auto counted = [](std::uint64_t all, std::uint64_t first, std::uint64_t step) {
            return all <= first ? 0 : (all - first + step - 1) / step;
        };
        const std::uint64_t columns = counted(sides.first, pass.firstColumn, pass.columns);
        const std::uint64_t lines = counted(sides.second, pass.firstLine, pass.lines);
        return columns == 0 ? 0 : lines * (1 + (columns * bits + 7) / 8); // 1: the filter
    };
    if (header[interlacingPlace] == 0)
        return bytesOf(wholePass);
    std::uint64_t bytes = 0;
    for (const InterlacedPass &pass : interlacedPasses)
        bytes += bytesOf(pass);
    return bytes;
}

QString endFault(QByteArrayView header, const QByteArray &pixels)
{
    if (pixels.isEmpty())
        return QStringLiteral("a broken PNG: it has no pixels (IDAT)");
    const auto [width, height] = sidesOf(header);
    if (width * height > std::uint64_t(largestFrameArea)) // is refused, whatever it has
        return {};
    const std::uint64_t needed = bytesOfPixels(header);
    const std::uint64_t there = inflatedBytes(pixels, needed);
    if (there >= needed)
        return {};
    return QStringLiteral("a broken PNG: its pixels (IDAT) end early, at byte %1 of %2")
        .arg(there)
        .arg(needed);
}

} // namespace

QString pngFault(const QByteArray &content)
{
    if (!content.startsWith("\x89PNG\r\n\x1a\n"))
        return {};
    QByteArrayView header;
    bool hasPalette = false;
    QByteArray pixels;
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
        if (header.isEmpty()) {
            if (type != "IHDR")
                return QStringLiteral("a broken PNG: it does not begin with its header (IHDR)");
            fault = headerFault(chunk);
            header = chunk;
        } else if (type == "IDAT") {
            if (pixels.isEmpty())
                fault = pixelsFault(chunk, header[typePlace], hasPalette);
            pixels += chunk;
        }
        hasPalette = hasPalette || type == "PLTE";
        if (!fault.isEmpty())
            return fault;
        if (type == "IEND")
            return endFault(header, pixels);
        at += frameOfChunk + qsizetype(length);
    }
}

} // namespace pixelplumb
