// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/pngheader.h"

#include <QtEndian>

#include <algorithm>
#include <array>

namespace pixelplumb {

namespace {

using ColourType = PngHeader::ColourType;

/// The bit depths that a colour type allows; none for an unknown type.
QByteArrayView depthsOf(ColourType type)
{
    switch (type) {
    case ColourType::Grey:
        return "\x01\x02\x04\x08\x10";
    case ColourType::Palette:
        return "\x01\x02\x04\x08";
    case ColourType::Rgb:
    case ColourType::GreyAlpha:
    case ColourType::Rgba:
        return "\x08\x10";
    }
    return {};
}

std::uint64_t samplesOfPixel(ColourType type)
{
    switch (type) {
    case ColourType::Rgb:
        return 3;
    case ColourType::GreyAlpha:
        return 2;
    case ColourType::Rgba:
        return 4;
    case ColourType::Grey:
    case ColourType::Palette:
        break;
    }
    return 1;
}

/// The pixels of every n-th column and line from a first one on.
struct Pass {
    std::uint64_t firstColumn, firstLine, columns, lines;
};
constexpr std::array wholePass = {Pass{0, 0, 1, 1}};
/// Adam7, ISO/IEC 15948, 8.2.
constexpr std::array interlacedPasses
    = {Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8}, Pass{2, 0, 4, 4},
       Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2}, Pass{0, 1, 1, 2}};

} // namespace

QString readPngHeader(QByteArrayView content, PngHeader &header)
{
    constexpr qsizetype size = 13;
    if (content.size() != size)
        return QStringLiteral("its header has %1 bytes in place of 13").arg(content.size());
    const auto byteAt = [content](qsizetype place) { return int(std::uint8_t(content[place])); };
    constexpr qsizetype heightPlace = 4, depthPlace = 8, typePlace = 9, waysPlace = 10;
    header.width = qFromBigEndian<quint32>(content.data());
    header.height = qFromBigEndian<quint32>(content.data() + heightPlace);
    header.depth = byteAt(depthPlace);
    header.colourType = ColourType(byteAt(typePlace));
    header.isInterlaced = byteAt(size - 1) == 1;
    if (!depthsOf(header.colourType).contains(content[depthPlace]))
        return QStringLiteral("its header says colour type %1 of %2 bits, which is none")
            .arg(byteAt(typePlace))
            .arg(header.depth);
    constexpr std::uint32_t largestSide = 1'000'000; // px, the limit of decoders
    if (header.width < 1 || header.height < 1 || header.width > largestSide
        || header.height > largestSide)
        return QStringLiteral("its header says %1 × %2 pixels")
            .arg(header.width)
            .arg(header.height);
    if (byteAt(waysPlace) != 0 || byteAt(waysPlace + 1) != 0 || byteAt(size - 1) > 1)
        return QStringLiteral("its header says a compression, filter or interlacing that is none");
    return {};
}

std::vector<PngLines> linesOf(const PngHeader &header)
{
    const std::uint64_t bits = std::uint64_t(header.depth) * samplesOfPixel(header.colourType);
    std::vector<PngLines> all;
    const auto add = [&](const Pass &pass) {
        const auto counted = [](std::uint64_t whole, std::uint64_t first, std::uint64_t step) {
            return whole <= first ? 0 : (whole - first + step - 1) / step;
        };
        const std::uint64_t columns = counted(header.width, pass.firstColumn, pass.columns);
        const std::uint64_t lines = counted(header.height, pass.firstLine, pass.lines);
        if (columns > 0 && lines > 0)
            all.push_back({1 + (columns * bits + 7) / 8, lines});
    };
    if (header.isInterlaced)
        std::ranges::for_each(interlacedPasses, add);
    else
        std::ranges::for_each(wholePass, add);
    return all;
}

} // namespace pixelplumb
