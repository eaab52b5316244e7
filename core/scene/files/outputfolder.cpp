// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/outputfolder.h"

#include "core/scene/files/filepath.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pixelplumb {

namespace {

/// Whether a path leads into a folder through any links, or will once it is made.
bool isIn(const QString &path, const QString &folder)
{
    namespace fs = std::filesystem;
    const fs::path whole(QFile::encodeName(folder).toStdString());
    std::error_code ignored;
    fs::path place = fs::absolute(QFile::encodeName(path).toStdString(), ignored);
    for (place = fs::weakly_canonical(place, ignored);; place = place.parent_path()) {
        if (fs::equivalent(place, whole, ignored))
            return true;
        if (place == place.parent_path())
            return false;
    }
}

} // namespace

std::optional<InputError> refusalOfFolder(const QString &folder)
{
    const QString expected = "a folder";
    const QFileInfo there(filePath(folder));
    if (there.exists() && !there.isDir())
        return InputError{folder, "is a file", expected};
    if (!there.exists() && there.isSymbolicLink())
        return InputError{
            folder, u"is a link to %1, which is not there"_s.arg(there.symLinkTarget()), expected};
    std::error_code error;
    std::filesystem::create_directories(
        QFile::encodeName(QDir::cleanPath(filePath(folder))).toStdString(), error);
    if (error)
        return InputError{folder, u"cannot be made: "_s + qt_error_string(error.value()), expected};
    if (!QFileInfo(filePath(folder)).isWritable())
        return InputError{folder, "cannot be written to", "a folder in which files can be made"};
    return std::nullopt;
}

bool lieInEachOther(const QString &one, const QString &other)
{
    return isIn(one, other) || isIn(other, one);
}

} // namespace pixelplumb
