// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/fileaccess.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <filesystem>

namespace pixelplumb {

namespace {

constexpr qint64 largestFile = qint64(256) << 20;

std::optional<InputError> writeThrough(QFileDevice &file, const QByteArray &content)
{
    if (file.write(content) == content.size() && file.flush())
        return std::nullopt;
    return InputError{
        file.fileName(), QStringLiteral("cannot be written: ") + file.errorString(), {}};
}

} // namespace

Result<QByteArray> readFile(const QString &path)
{
    const auto refusal = [&](const QString &why) {
        return InputError{path, QStringLiteral("cannot be read: ") + why, {}};
    };
    if (QFileInfo(path).isDir())
        return refusal(QStringLiteral("it is a folder"));
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return refusal(file.errorString());
    QByteArray content = file.read(largestFile + 1);
    if (file.error() != QFileDevice::NoError)
        return refusal(file.errorString());
    if (content.size() > largestFile)
        return refusal(QStringLiteral("it is larger than 256 MiB"));
    return content;
}

Result<QByteArray> readRegularFile(const QString &path)
{
    const QFileInfo file(path);
    if (file.exists() && !file.isFile() && !file.isDir())
        return InputError{path, QStringLiteral("cannot be read: it is a pipe or a device"),
                          QStringLiteral("a file")};
    return readFile(path);
}

InputError errorIn(const QString &path, InputError error)
{
    error.place = error.place.isEmpty() ? path : path + QStringLiteral(", ") + error.place;
    return error;
}

InputError readingCancelled(const QString &place)
{
    return {place, QStringLiteral("the reading was cancelled"), {}};
}

bool isSameFile(const QString &path, const QString &other)
{
    const std::filesystem::path first(path.toStdU16String());
    std::error_code error;
    return std::filesystem::is_regular_file(first, error)
        && std::filesystem::equivalent(first, other.toStdU16String(), error);
}

std::optional<InputError> writeFile(const QString &path, const QByteArray &content)
{
    const auto refusal = [&](const QFileDevice &file) {
        return InputError{path, QStringLiteral("cannot be written: ") + file.errorString(), {}};
    };
    const QFileInfo target(path);
    if (target.exists() && !target.isFile() && !target.isDir()) {
        QFile device(path);
        if (!device.open(QIODevice::WriteOnly))
            return refusal(device);
        return writeThrough(device, content);
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return refusal(file);
    if (auto error = writeThrough(file, content))
        return error;
    if (!file.commit())
        return refusal(file);
    return std::nullopt;
}

} // namespace pixelplumb
