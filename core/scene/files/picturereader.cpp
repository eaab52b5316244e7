// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/picturereader.h"

#include "core/frame/framespec.h"

#include <QtEndian>

#include <algorithm>
#include <cstdlib>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

/// The fields of the file header and of BITMAPINFOHEADER, in bytes from the file's start.
enum Field {
    PixelsOffset = 10,
    HeaderSize = 14,
    Width = 18,
    Height = 22,
    BitsOfAPixel = 28,
    Compression = 30,
    HeadersEnd = 54,
};

/// The fields of the older BITMAPCOREHEADER, two bytes each; it has no compression.
enum CoreField {
    CoreWidth = 18,
    CoreHeight = 20,
    CoreBitsOfAPixel = 24,
    CoreHeadersEnd = 26,
};

/// Whether the pixels stand at their full size: compression 0, or 3 with masks of the channels.
bool isUncompressed(qint64 compression) { return compression == 0 || compression == 3; }

qint64 fieldAt(const QByteArray &content, Field place)
{
    return qFromLittleEndian<qint32>(content.constData() + place);
}

qint64 shortFieldAt(const QByteArray &content, int place)
{
    return qFromLittleEndian<quint16>(content.constData() + place);
}

/// Lines are padded to whole words of four bytes.
qint64 bytesOfLine(qint64 width, qint64 bitsOfAPixel)
{
    return (width * bitsOfAPixel + 31) / 32 * 4;
}

bool hasCoreHeader(const QByteArray &content)
{
    constexpr qint64 coreHeaderSize = 12;
    return content.size() >= CoreHeadersEnd && fieldAt(content, HeaderSize) == coreHeaderSize;
}

/// A negative height means lines from the top down.
qint64 bytesOfPixels(const QByteArray &content)
{
    if (hasCoreHeader(content))
        return bytesOfLine(shortFieldAt(content, CoreWidth),
                           shortFieldAt(content, CoreBitsOfAPixel))
            * shortFieldAt(content, CoreHeight);
    return bytesOfLine(fieldAt(content, Width), shortFieldAt(content, BitsOfAPixel))
        * std::abs(fieldAt(content, Height));
}

/// How many bytes of pixels a BMP file lacks: "a BMP that ends early, 12 of 9216 bytes of pixels
/// are missing", or that its pixels are compressed or have five bits a channel, which its decoder
/// does not spread over 0 … 255; empty for a whole BMP and for other files. Its
/// decoder accepts such a file and leaves in the last lines whatever the memory held.
QString bmpFault(const QByteArray &content)
{
    if (!content.startsWith("BM"))
        return {};
    if (content.size() < HeadersEnd && !hasCoreHeader(content))
        return u"a BMP that ends early, in its header"_s;
    // Its runs may leave pixels out, of which the reader would show what the memory held before.
    if (!hasCoreHeader(content) && !isUncompressed(fieldAt(content, Compression)))
        return u"a compressed BMP, in which pixels may be left out; save it "
               "uncompressed"_s;
    if (!hasCoreHeader(content) && shortFieldAt(content, BitsOfAPixel) == 16)
        return u"a BMP of 16 bits a pixel, which have no 256 levels; save it with 24"_s;
    const qint64 needed = bytesOfPixels(content);
    const qint64 missing
        = std::min(needed, fieldAt(content, PixelsOffset) + needed - content.size());
    if (missing <= 0)
        return {};
    return u"a BMP that ends early, %1 of %2 bytes of pixels are missing"_s.arg(missing).arg(
        needed);
}

} // namespace

PictureReader::PictureReader(const QByteArray &content)
    : m_bmpFault(bmpFault(content))
    , m_content(content)
    , m_buffer(&m_content)
    , m_reader(&m_buffer)
{
    constexpr int mostMegabytes = int(largestFrameArea * 8 >> 20); // two bytes per channel
    QImageReader::setAllocationLimit(mostMegabytes);
    if (PngPicture::isPng(content))
        m_png.emplace(content);
    else if (PnmPicture::isPnm(content))
        m_pnm.emplace(content);
}

QByteArray PictureReader::format()
{
    return m_png ? "png" : m_pnm ? m_pnm->format() : m_reader.format();
}

QSize PictureReader::size()
{
    if (m_png)
        return m_png->size();
    if (m_pnm)
        return m_pnm->size();
    // Of a BMP whose lines stand from the top down, Qt tells a height below 0.
    const QSize size = m_reader.size();
    return {size.width(), std::abs(size.height())};
}

} // namespace pixelplumb
