// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fields/referredfiles.h"

#include "core/geometry/appearance.h"
#include "core/scene/files/fileaccess.h"
#include "core/scene/files/filepath.h"
#include "core/scene/files/meshfile.h"
#include "core/scene/files/picturereader.h"
#include "core/scene/scenefile.h"
#include "core/scene/text/byteordermark.h"
#include "core/scene/text/jsonreader.h"
#include "core/scene/text/result.h"

#include <QDir>
#include <QFileInfo>
#include <QSet>

namespace pixelplumb {

namespace {

inline constexpr int largestTextureSide = 4096; // texels

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
    return {path, u"a picture of %1 × %2"_s.arg(size.width()).arg(size.height()),
            u"at most %1 × %1"_s.arg(largestTextureSide)};
}

/// Reads a picture as texels; its transparency is ignored. The size is judged by the header, before
/// anything is decoded.
Result<Texture> readTexture(const QString &path)
{
    Result<QByteArray> content = readRegularFile(path);
    if (!content)
        return content.error();
    PictureReader reader(withoutByteOrderMark(*content));
    if (!reader.fault().isEmpty())
        return InputError{path, u"no picture: "_s + reader.fault(), "a whole file"};
    if (const QByteArray format = reader.format(); !format.isEmpty() && !isTextureFormat(format))
        return InputError{path, u"a picture of the kind %1"_s.arg(QString::fromLatin1(format)),
                          "a picture such as PNG or JPEG"};
    if (const QSize size = reader.size(); size.isValid() && !isWithinLimits(size))
        return tooLarge(path, size);
    const QImage picture = reader.read().convertToFormat(QImage::Format_RGB32);
    if (picture.isNull())
        return InputError{path, u"no picture: "_s + reader.errorString(),
                          "a picture such as PNG or JPEG"};
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

/// For a whole scene: four of the largest textures.
constexpr std::size_t mostTexels = std::size_t(4) * largestTextureSide * largestTextureSide;

} // namespace

QString ReferredFiles::pathOf(const QString &name) const
{
    return QDir::cleanPath(QDir(m_folder).absoluteFilePath(filePath(name)));
}

Result<std::shared_ptr<const Texture>> ReferredFiles::texture(const QString &name)
{
    const bool isChecker = name == u"checker"_s;
    const QString path = isChecker ? name : pathOf(name);
    if (const auto known = m_textures.value(path))
        return known;
    Result<Texture> texture = isChecker ? checkerTexture() : readTexture(path);
    if (!texture)
        return texture.error();
    m_texels += texture->texels.size();
    if (m_texels > mostTexels)
        return InputError{path,
                          u"the scene's textures have %1 texels, %2 MiB"_s.arg(m_texels).arg(
                              m_texels * sizeof(Colour) >> 20),
                          u"at most %1 in all"_s.arg(mostTexels)};
    return m_textures[path] = std::make_shared<const Texture>(std::move(*texture));
}

Result<std::shared_ptr<const Mesh>> ReferredFiles::mesh(const QString &name)
{
    const QString path = pathOf(name);
    if (const auto known = m_meshes.value(path))
        return known;
    Result<Mesh> mesh = readMesh(path, m_listener);
    if (!mesh)
        return mesh.error();
    return m_meshes[path] = std::make_shared<const Mesh>(std::move(*mesh));
}

qint64 bytesToRead(const QString &path)
{
    const QFileInfo file(filePath(path));
    qint64 bytes = file.size();
    if (!file.isFile() || bytes > shortText)
        return bytes;
    const Result<QByteArray> text = readFile(path);
    if (!text)
        return bytes;
    QSet<QString> names;
    const JsonReader json(*text);
    const JsonNode materials = json.root()["materials"];
    for (const QString &material : materials.keys())
        names.insert(materials[material]["texture"].toString());
    for (const JsonNode &primitive : json.root()["primitives"].elements())
        names.insert(primitive["mesh"].toString());
    names.remove(QString());
    names.removeIf([](const QString &name) { return name.contains(QChar(0)); });
    for (const QString &name : names)
        bytes += QFileInfo(file.absoluteDir().absoluteFilePath(filePath(name))).size();
    return bytes;
}

QString nameInFolder(const std::string &name, const QString &folder)
{
    const QString path = QString::fromStdString(name);
    if (folder.isEmpty() || QDir::isRelativePath(filePath(path)))
        return path;
    return QDir(folder).relativeFilePath(path);
}

} // namespace pixelplumb
