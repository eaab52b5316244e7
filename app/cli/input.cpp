// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input.h"

#include "core/scene/fileaccess.h"

#include <QFile>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <optional>

namespace pixelplumb::cli {

namespace {

using FileStatus = struct stat;

/// The regular file that an open descriptor leads to, however it was reached.
std::optional<FileStatus> regularFile(int descriptor)
{
    FileStatus status = {};
    const bool isRegular = fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    return isRegular ? std::optional(status) : std::nullopt;
}

/// The same of a path. It is not opened: a pipe could be read but once.
std::optional<FileStatus> regularFile(const QString &path)
{
    FileStatus status = {};
    const bool isRegular
        = stat(QFile::encodeName(path).constData(), &status) == 0 && S_ISREG(status.st_mode);
    return isRegular ? std::optional(status) : std::nullopt;
}

bool isOneFile(const std::optional<FileStatus> &file, const std::optional<FileStatus> &other)
{
    return file && other && file->st_dev == other->st_dev && file->st_ino == other->st_ino;
}

std::optional<InputError> refusalToReplace(const QString &path)
{
    const auto input = path == QStringLiteral("-") ? regularFile(STDIN_FILENO) : regularFile(path);
    // Messages would harm the file as much: where they go there, even the refusal is kept back.
    const bool isForMessages = isOneFile(input, regularFile(STDERR_FILENO));
    if (isForMessages && !std::freopen("/dev/null", "w", stderr))
        std::fclose(stderr);
    if (!isForMessages && !isOneFile(input, regularFile(STDOUT_FILENO)))
        return std::nullopt;
    return InputError{QStringLiteral("standard output"),
                      QStringLiteral("is the input, which it would replace"),
                      QStringLiteral("another file")};
}

} // namespace

Result<QByteArray> readInput(const QString &path)
{
    if (path.isEmpty())
        return InputError{QStringLiteral("“”"), QStringLiteral("names no file"),
                          QStringLiteral("the name of one, or - for standard input")};
    if (auto refusal = refusalToReplace(path))
        return *refusal;
    if (path != QStringLiteral("-"))
        return readFile(path);
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly))
        return InputError{QStringLiteral("standard input"), input.errorString(), {}};
    return input.readAll();
}

} // namespace pixelplumb::cli
