// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/fileaccess.h"

#include "core/scene/files/filepath.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/files/outputfile.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>

#include <algorithm>

namespace pixelplumb {

namespace {

/// Waits for a pipe or device, since the user named it. Files that have no data yet, such as some
/// in /proc, fail instead.
bool openToRead(QFile &file)
{
    if (!QFileInfo(file).isFile())
        return file.open(QIODevice::ReadOnly);
    const int opened
        = ::open(QFile::encodeName(file.fileName()).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    // If open() fails, QFile reports why.
    return opened >= 0 ? file.open(opened, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle)
                       : file.open(QIODevice::ReadOnly);
}

} // namespace

Result<QByteArray> readDevice(const QString &place, QIODevice &device, qint64 most)
{
    constexpr qint64 piece = qint64(1) << 20;
    QByteArray content;
    content.reserve(qBound<qint64>(0, device.size(), most));
    while (content.size() <= most) {
        const QByteArray next = device.read(std::min(piece, most + 1 - content.size()));
        if (next.isEmpty())
            break;
        content += next;
    }
    const auto *file = qobject_cast<QFileDevice *>(&device);
    if (file && file->error() != QFileDevice::NoError)
        return InputError{place, u"cannot be read: "_s + file->errorString(), {}};
    if (content.size() > most)
        return InputError{place, u"cannot be read: it is larger than %1 MiB"_s.arg(most >> 20), {}};
    return content;
}

Result<QByteArray> readFile(const QString &path, qint64 most)
{
    const auto refusal = [&](const QString &why) {
        return InputError{path, u"cannot be read: "_s + why, {}};
    };
    if (QFileInfo(filePath(path)).isDir())
        return refusal("it is a folder");
    if (auto objection = noteInput(path))
        return *objection;
    QFile file(filePath(path));
    if (!openToRead(file))
        return refusal(file.errorString());
    return readDevice(path, file, most);
}

Result<QByteArray> readRegularFile(const QString &path, qint64 most)
{
    const QFileInfo file(filePath(path));
    if (file.exists() && !file.isFile() && !file.isDir())
        return InputError{path, "cannot be read: it is a pipe or a device", "a file"};
    return readFile(path, most);
}

InputError errorIn(const QString &path, InputError error)
{
    error.place = error.place.isEmpty() ? path : path + u", "_s + error.place;
    return error;
}

InputError readingCancelled(const QString &place)
{
    return {place, "the reading was cancelled", {}};
}

std::optional<InputError> writeFile(const QString &path, const QByteArray &content, WrittenAs as)
{
    OutputFile file(path, as);
    if (auto error = file.open())
        return error;
    if (file.device().write(content) != content.size())
        return file.error();
    return file.finish();
}

} // namespace pixelplumb
