// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/submissionfolder.h"
#include "core/grade/descriptor.h"

#include <QCryptographicHash>
#include <QFile>

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

namespace pixelplumb {

namespace {

constexpr std::int64_t largestDigested = std::int64_t(256) << 20; // bytes
constexpr std::size_t mostDigested = 10'000; // files

using Path = std::filesystem::path;

/// The path and everything below it, sorted; links are not followed.
std::optional<std::vector<Path>> pathsFrom(const Path &top)
{
    std::error_code error;
    std::vector<Path> paths = {top};
    if (std::filesystem::symlink_status(top, error).type() != std::filesystem::file_type::directory)
        return paths;
    std::filesystem::recursive_directory_iterator each(top, error);
    for (; !error && each != std::filesystem::recursive_directory_iterator();
         each.increment(error)) {
        paths.push_back(each->path());
        if (paths.size() > mostDigested)
            return std::nullopt;
    }
    if (error)
        return std::nullopt;
    std::ranges::sort(paths);
    return paths;
}

/// Adds a file's size and content; false where it is larger than `left`.
bool addContent(const Path &path, std::int64_t &left, QCryptographicHash &hash)
{
    const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status = {};
    if (!file.isOpen() || fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
        return true; // for a link, pipe or folder only the name counts
    left -= status.st_size;
    QFile device;
    if (left < 0 || !device.open(file.number(), QIODevice::ReadOnly | QIODevice::Unbuffered))
        return false;
    hash.addData(QByteArray::number(qint64(status.st_size))
                 + ((status.st_mode & S_IXUSR) != 0 ? "x" : "-"));
    hash.addData(device.read(status.st_size));
    return true;
}

} // namespace

std::optional<QByteArray> SubmissionEntry::digest() const
{
    const Path folder(m_folder.toStdString());
    const auto paths = pathsFrom(folder / m_name.toStdString());
    if (!paths)
        return std::nullopt;
    QCryptographicHash hash(QCryptographicHash::Sha256);
    std::int64_t left = largestDigested;
    for (const Path &path : *paths) {
        hash.addData(QByteArray::fromStdString(path.lexically_relative(folder).string()) + '\0');
        if (!addContent(path, left, hash))
            return std::nullopt;
    }
    return hash.result();
}

} // namespace pixelplumb
