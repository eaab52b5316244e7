// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/outputfile.h"

#include "core/scene/files/filepath.h"
#include "core/scene/files/inputrecord.h"

#include <QDeadlineTimer>
#include <QFileInfo>
#include <QSaveFile>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

namespace pixelplumb {

namespace {

// No longer than a window may freeze.
constexpr std::chrono::milliseconds patience{40};
constexpr std::chrono::milliseconds glance{5};

/// Opens a pipe as soon as it has a reader; after `patience` without one, false and errno ENXIO: a
/// plain open would wait for ever.
bool openPipe(QFile &file)
{
    const QByteArray name = QFile::encodeName(file.fileName());
    const QDeadlineTimer deadline(patience);
    int pipe = -1;
    while ((pipe = ::open(name.constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC)) < 0) {
        if (errno != ENXIO || deadline.hasExpired())
            return false;
        std::this_thread::sleep_for(glance);
    }
    return fcntl(pipe, F_SETFL, O_WRONLY) == 0
        && file.open(pipe, QIODevice::WriteOnly, QFileDevice::AutoCloseHandle);
}

} // namespace

OutputFile::OutputFile(QString path, WrittenAs as)
    : m_path(std::move(path))
    , m_as(as)
{
}

std::optional<InputError> OutputFile::open()
{
    if (m_as == WrittenAs::Export) {
        if (auto refusal = refusalToWrite(m_path))
            return refusal;
    }
    // A device or pipe cannot be replaced by a finished file.
    const QString path = filePath(m_path);
    const QFileInfo target(path);
    const bool isReplaced = !target.exists() || target.isFile() || target.isDir();
    if (isReplaced) {
        m_file = std::make_unique<QSaveFile>(path);
    } else {
        auto file = std::make_unique<QFile>(path);
        std::error_code ignored;
        if (std::filesystem::is_fifo(QFile::encodeName(m_path).toStdString(), ignored)
            && !openPipe(*file))
            return InputError{
                m_path,
                u"cannot be written: "_s
                    + (errno == ENXIO ? u"nobody reads the pipe"_s : qt_error_string(errno)),
                {}};
        m_file = std::move(file);
    }
    return m_file->isOpen() || m_file->open(QIODevice::WriteOnly) ? std::nullopt
                                                                  : std::optional(error());
}

std::optional<InputError> OutputFile::finish()
{
    // Checked first: a discarded file no longer says why.
    if (m_file->error() != QFileDevice::NoError || !m_file->flush())
        return error();
    auto *file = qobject_cast<QSaveFile *>(m_file.get());
    return !file || file->commit() ? std::nullopt : std::optional(error());
}

InputError OutputFile::error(const QString &otherwise) const
{
    return writingError(m_path, *m_file, otherwise);
}

InputError writingError(const QString &place, const QFileDevice &device, const QString &otherwise)
{
    QString why = device.error() != QFileDevice::NoError ? device.errorString() : otherwise;
    // When a disk takes only part of a write, Qt does not know why, or reports no error at all;
    // writing one more byte reveals it.
    if ((device.error() != QFileDevice::NoError || why.isEmpty()) && device.handle() >= 0
        && ::write(device.handle(), "", 1) < 0)
        why = qt_error_string(errno);
    return {place, u"cannot be written"_s + (why.isEmpty() ? why : u": "_s + why), {}};
}

} // namespace pixelplumb
