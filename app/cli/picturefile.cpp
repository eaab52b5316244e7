// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/picturefile.h"

#include "app/cli/input.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>

namespace pixelplumb::cli {

Result<Picture> readPicture(const QString &path)
{
    const Result<QByteArray> content = readInput(path, largestPictureFile);
    if (!content)
        return content.error();
    return parsePicture(*content, path);
}

std::optional<ExitCode> refusalOfSizes(const SizedInput &one, const SizedInput &other)
{
    if (one.size == other.size)
        return std::nullopt;
    sayLine(
        QStringLiteral("%1 has %2 × %3 pixels%7, %4 has %5 × %6%8")
            .arg(one.path, QString::number(one.size.width()), QString::number(one.size.height()),
                 other.path, QString::number(other.size.width()),
                 QString::number(other.size.height()), sizeHint(one.size, other.size),
                 one.size == other.size.transposed() ? QString() : sizeHint(other.size, one.size)));
    return ExitCode::SizesDiffer;
}

const QStringList &pictureFormats()
{
    static const QStringList formats
        = {QStringLiteral("png"), QStringLiteral("bmp"), QStringLiteral("ppm")};
    return formats;
}

Result<QString> pictureFormatOf(const QString &option, const QString &path)
{
    const QFileInfo file(path);
    const bool isStream = path == QStringLiteral("-") || path.startsWith(QStringLiteral("/dev/"))
        || (file.exists() && !file.isFile() && !file.isDir());
    const QString format = file.suffix().toLower();
    if (pictureFormats().contains(format))
        return format;
    if (isStream)
        return pictureFormats().front();
    return InputError{
        option + u' ' + path,
        format.isEmpty() ? QStringLiteral("the name does not say which kind of picture")
                         : QStringLiteral("unknown kind of picture"),
        QStringLiteral("a name that ends in .") + pictureFormats().join(QStringLiteral(", ."))};
}

Result<QString> pictureFormatOf(const CommandLine &line, const QString &option)
{
    return line.isSet(option) ? pictureFormatOf(QStringLiteral("-o"), line.value(option))
                              : pictureFormats().front();
}

std::optional<InputError> writePicture(const QImage &picture, Output &output, const QString &format)
{
    if (auto error = output.open())
        return error;
    // libpng would print its own error if it wrote to the file directly.
    QBuffer encoded;
    QImageWriter writer(&encoded, format.toLatin1());
    if (!writer.write(picture))
        return output.error(writer.errorString());
    if (output.device().write(encoded.data()) != encoded.size())
        return output.error();
    return output.finish();
}

} // namespace pixelplumb::cli
