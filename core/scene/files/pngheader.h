// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>

#include <cstdint>
#include <vector>

namespace pixelplumb {

/// A PNG's header: ISO/IEC 15948, 11.2.2.
struct PngHeader {
    enum class ColourType { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

    std::uint32_t width = 0, height = 0; ///< px, 1 …
    int depth = 0; ///< bits of a sample
    ColourType colourType = ColourType::Grey;
    bool isInterlaced = false;

    std::uint64_t area() const { return std::uint64_t(width) * height; }
};

/// Reads a header's content; returns what is wrong with it, or empty.
QString readPngHeader(QByteArrayView content, PngHeader &header);

/// Lines of pixels of equal length.
struct PngLines {
    std::uint64_t bytes = 0; ///< of each line, with its filter byte, which comes first
    std::uint64_t count = 0;
};
/// The lines of the uncompressed pixels in their order: one pass over the picture, or the seven of
/// an interlaced one (8.2) without the empty ones.
std::vector<PngLines> linesOf(const PngHeader &header);

} // namespace pixelplumb
