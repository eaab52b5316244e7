// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/pngpicture.h"

#include <QtEndian>

namespace pixelplumb {

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView signature("\x89PNG\r\n\x1a\n");

/// The file without the chunks that pixels do not need, among them gamma and colour profiles. What
/// follows a damaged chunk stays: libpng says what is wrong with it.
std::string plain(QByteArrayView png)
{
    constexpr qsizetype frameOfChunk = 12; // length, type and checksum
    const auto isNeeded = [](QByteArrayView type) {
        constexpr char ancillary = 0x20; // critical chunks begin with a capital
        return (type.front() & ancillary) == 0 || type == "tRNS";
    };
    std::string kept(signature.data(), std::size_t(signature.size()));
    qsizetype place = signature.size();
    while (png.size() - place >= frameOfChunk) {
        const auto length = qFromBigEndian<quint32>(png.data() + place);
        if (length > quint64(png.size() - place - frameOfChunk))
            break;
        const QByteArrayView chunk = png.sliced(place, qsizetype(length) + frameOfChunk);
        if (isNeeded(chunk.sliced(4, 4)))
            kept.append(chunk.data(), std::size_t(chunk.size()));
        place += chunk.size();
    }
    return kept.append(png.data() + place, std::size_t(png.size() - place));
}

/// libpng's simplified reader mixes up the levels of such a file's passes (1.6.39).
bool isInterlacedWith16Bits(const std::string &png)
{
    constexpr std::size_t depthPlace = 24, interlacePlace = 28; // in the header chunk, the first
    return png.size() > interlacePlace && png[depthPlace] == 16 && png[interlacePlace] == 1;
}

} // namespace

bool PngPicture::isPng(const QByteArray &content) { return content.startsWith(signature); }

PngPicture::PngPicture(const QByteArray &content)
    : m_content(plain(content))
{
    m_image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&m_image, m_content.data(), m_content.size()) == 0) {
        keepFault();
        return;
    }
    m_image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    m_size = {int(m_image.width), int(m_image.height)};
}

PngPicture::~PngPicture() { png_image_free(&m_image); }

QImage PngPicture::read()
{
    if (!m_fault.isEmpty())
        return {};
    const bool isTransparent = (m_image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    QImage picture(m_size, isTransparent ? QImage::Format_ARGB32 : QImage::Format_RGB32);
    if (picture.isNull()) {
        m_fault = "no memory for its pixels";
        return {};
    }
    m_image.format // QRgb in memory
        = QSysInfo::ByteOrder == QSysInfo::LittleEndian ? PNG_FORMAT_BGRA : PNG_FORMAT_ARGB;
    if (png_image_finish_read(&m_image, nullptr, picture.bits(), 0, nullptr) != 0)
        return isInterlacedWith16Bits(m_content)
            ? QImage::fromData(
                  QByteArray::fromRawData(m_content.data(), qsizetype(m_content.size())), "png")
                  .convertToFormat(picture.format())
            : picture;
    keepFault();
    return {};
}

void PngPicture::keepFault()
{
    m_fault = u"a broken PNG: "_s + QString::fromLatin1(m_image.message);
}

} // namespace pixelplumb
