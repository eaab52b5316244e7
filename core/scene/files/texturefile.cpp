// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/texturefile.h"

#include "core/scene/files/fileaccess.h"
#include "core/scene/files/picturereader.h"

namespace pixelplumb {

namespace {

bool isWithinLimits(const QSize &size)
{
    return size.width() >= 1 && size.height() >= 1 && size.width() <= largestTextureSide
        && size.height() <= largestTextureSide;
}

/// Pixel formats only: a vector drawing could name other files, or never end.
bool isTextureFormat(const QByteArray &format)
{
    static const QList<QByteArray> formats
        = {"png", "jpg", "jpeg", "bmp", "ppm", "pgm", "pbm", "gif", "webp"};
    return formats.contains(format);
}

InputError tooLarge(const QString &path, const QSize &size)
{
    return {path, QStringLiteral("a picture of %1 × %2").arg(size.width()).arg(size.height()),
            QStringLiteral("at most %1 × %1").arg(largestTextureSide)};
}

} // namespace

Result<Texture> readTexture(const QString &path)
{
    Result<QByteArray> content = readRegularFile(path);
    if (!content)
        return content.error();
    PictureReader reader(*content);
    if (!reader.fault().isEmpty())
        return InputError{path, QStringLiteral("no picture: ") + reader.fault(),
                          QStringLiteral("a whole file")};
    if (const QByteArray format = reader.format(); !format.isEmpty() && !isTextureFormat(format))
        return InputError{
            path, QStringLiteral("a picture of the kind %1").arg(QString::fromLatin1(format)),
            QStringLiteral("a picture such as PNG or JPEG")};
    if (const QSize size = reader.size(); size.isValid() && !isWithinLimits(size))
        return tooLarge(path, size);
    const QImage picture = reader.read().convertToFormat(QImage::Format_RGB32);
    if (picture.isNull())
        return InputError{path, QStringLiteral("no picture: ") + reader.errorString(),
                          QStringLiteral("a picture such as PNG or JPEG")};
    if (!isWithinLimits(picture.size()))
        return tooLarge(path, picture.size());
    Texture texture{path.toStdString(), picture.width(), picture.height(), {}};
    texture.texels.reserve(std::size_t(picture.width()) * std::size_t(picture.height()));
    for (int row = picture.height() - 1; row >= 0; --row) {
        const auto *pixels = reinterpret_cast<const QRgb *>(picture.constScanLine(row));
        for (int column = 0; column < picture.width(); ++column)
            texture.texels.push_back(unpacked(pixels[column]));
    }
    return texture;
}

} // namespace pixelplumb
