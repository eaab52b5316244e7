// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/outputfolder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pixelplumb {

std::optional<InputError> refusalOfFolder(const QString &folder)
{
    const QString expected = QStringLiteral("a folder");
    const QFileInfo there(folder);
    if (there.exists() && !there.isDir())
        return InputError{folder, QStringLiteral("is a file"), expected};
    if (!there.exists() && there.isSymbolicLink())
        return InputError{
            folder,
            QStringLiteral("is a link to %1, which is not there").arg(there.symLinkTarget()),
            expected};
    std::error_code error;
    std::filesystem::create_directories(QFile::encodeName(QDir::cleanPath(folder)).toStdString(),
                                        error);
    if (error)
        return InputError{
            folder, QStringLiteral("cannot be made: ") + qt_error_string(error.value()), expected};
    if (!QFileInfo(folder).isWritable())
        return InputError{folder, QStringLiteral("cannot be written to"),
                          QStringLiteral("a folder in which files can be made")};
    return std::nullopt;
}

} // namespace pixelplumb
