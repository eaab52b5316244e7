// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/inputrecord.h"

#include <QFile>

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <compare>
#include <cstdlib>
#include <map>
#include <mutex>
#include <set>

namespace pixelplumb {

namespace {

/// Identifies a regular file, however it is reached.
struct FileIdentity {
    dev_t device = 0;
    ino_t number = 0;

    friend auto operator<=>(const FileIdentity &, const FileIdentity &) = default;
};

std::optional<FileIdentity> identityIn(int result, const struct stat &status)
{
    if (result != 0 || !S_ISREG(status.st_mode))
        return std::nullopt;
    return FileIdentity{status.st_dev, status.st_ino};
}

/// None unless it is a regular file. It is not opened: a pipe can be read only once.
std::optional<FileIdentity> identityOf(const QByteArray &path)
{
    struct stat status = {};
    return identityIn(stat(path.constData(), &status), status);
}
std::optional<FileIdentity> identityOf(const QString &path)
{
    return identityOf(QFile::encodeName(path));
}

std::optional<FileIdentity> identityOf(int descriptor)
{
    struct stat status = {};
    return identityIn(fstat(descriptor, &status), status);
}

/// The path without links, in the system's own bytes, which need not be UTF-8; empty where nothing
/// is.
QByteArray canonical(const QByteArray &path)
{
    char *const found = realpath(path.constData(), nullptr);
    const QByteArray whole(found);
    std::free(found);
    return whole;
}
QByteArray canonical(const QString &path) { return canonical(QFile::encodeName(path)); }

struct Inputs {
    std::mutex mutex;
    int records = 0; ///< alive
    std::set<QByteArray> paths; ///< canonical
    std::set<QByteArray> folders; ///< canonical
    std::multimap<FileIdentity, QByteArray> files; ///< the file at each path when it was read
    bool hasStandardInput = false;
};

Inputs &inputs()
{
    static Inputs all;
    return all;
}

/// A deleted file's inode number may be reused, so the path is looked up again.
bool isInput(const std::optional<FileIdentity> &file)
{
    if (!file)
        return false;
    Inputs &all = inputs();
    const std::lock_guard lock(all.mutex);
    if (all.hasStandardInput && identityOf(STDIN_FILENO) == file)
        return true;
    const auto [first, end] = all.files.equal_range(*file);
    return std::any_of(first, end,
                       [&](const auto &each) { return identityOf(each.second) == file; });
}

bool isPathOfInput(const QString &path)
{
    Inputs &all = inputs();
    const std::lock_guard lock(all.mutex);
    return all.paths.contains(canonical(path));
}

bool isIn(const QByteArray &folder, const QByteArray &file)
{
    return file.startsWith(folder.endsWith('/') ? folder : folder + '/');
}

/// False for a file that does not exist.
bool isInInputFolder(const QString &path)
{
    const QByteArray file = canonical(path);
    Inputs &all = inputs();
    const std::lock_guard lock(all.mutex);
    return std::ranges::any_of(all.folders,
                               [&](const QByteArray &folder) { return isIn(folder, file); });
}

InputError wouldReplace(const QString &place)
{
    return {place, "is the input, which it would replace", "another file"};
}

InputError standardOutputWouldReplace() { return wouldReplace("standard output"); }

std::optional<InputError> refusalToRead(const std::optional<FileIdentity> &file)
{
    if (file && (identityOf(STDOUT_FILENO) == file || identityOf(STDERR_FILENO) == file))
        return standardOutputWouldReplace();
    return std::nullopt;
}

} // namespace

std::optional<InputError> refusalToRead(int descriptor)
{
    return refusalToRead(identityOf(descriptor));
}

InputRecord::InputRecord()
{
    const std::lock_guard lock(inputs().mutex);
    ++inputs().records;
}

InputRecord::~InputRecord()
{
    Inputs &all = inputs();
    const std::lock_guard lock(all.mutex);
    if (--all.records > 0)
        return;
    all.paths.clear();
    all.folders.clear();
    all.files.clear();
    all.hasStandardInput = false;
}

std::optional<InputError> noteInput(const QString &path)
{
    const std::optional<FileIdentity> file = identityOf(path);
    if (!file)
        return std::nullopt;
    Inputs &all = inputs();
    if (const std::lock_guard lock(all.mutex); all.records > 0) {
        const QByteArray whole = canonical(path);
        if (all.paths.insert(whole).second)
            all.files.emplace(*file, whole);
    }
    return refusalToRead(file);
}

std::optional<InputError> noteInputFolder(const QString &path)
{
    const QByteArray folder = canonical(path);
    if (folder.isEmpty())
        return std::nullopt;
    Inputs &all = inputs();
    if (const std::lock_guard lock(all.mutex); all.records > 0)
        all.folders.insert(folder);
    struct stat output = {};
    return fstat(STDOUT_FILENO, &output) == 0 && S_ISREG(output.st_mode) && output.st_size > 0
            && isIn(folder, canonical(QByteArray("/proc/self/fd/1")))
        ? std::optional(standardOutputWouldReplace())
        : std::nullopt;
}

std::optional<InputError> noteStandardInput()
{
    Inputs &all = inputs();
    if (const std::lock_guard lock(all.mutex); all.records > 0)
        all.hasStandardInput = true;
    return refusalToRead(identityOf(STDIN_FILENO));
}

bool isInput(const QString &path)
{
    const std::optional<FileIdentity> file = identityOf(path);
    return file && (isInput(file) || isPathOfInput(path) || isInInputFolder(path));
}

bool isInput(int descriptor) { return isInput(identityOf(descriptor)); }

std::optional<InputError> refusalToWrite(const QString &path)
{
    if (!isInput(path))
        return std::nullopt;
    if (isInput(identityOf(path)) || isPathOfInput(path))
        return wouldReplace(path);
    return InputError{
        path, "lies in a folder that is shown to a program, or graded, and may have been read",
        "a new file, or one elsewhere"};
}

std::optional<InputError> refusalToPrint()
{
    return isInput(STDOUT_FILENO) ? std::optional(standardOutputWouldReplace()) : std::nullopt;
}

bool isSameFile(const QString &path, const QString &other)
{
    const std::optional<FileIdentity> file = identityOf(path);
    return file && file == identityOf(other);
}

} // namespace pixelplumb
