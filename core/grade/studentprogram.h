// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QStringList>

namespace pixelplumb {

/// A program that somebody else wrote, as a command: with the whole paths of the files that it
/// names, for it runs in a folder of its own.
struct StudentProgram {
    QString path;
    QStringList arguments;
    QStringList shown; ///< files and folders of its own that it is to read, beside the system's
};

/// What of the files that its command names a program is shown.
enum class ShownFiles {
    WithFolders, ///< and all that lies in their folders: modules, tables
    Alone,
};

/// The program that the first word names (a file, or what PATH holds), with the other words. Where
/// a folder is the person's own, or holds others' too, only the file itself is shown. What is shown
/// is an input from then on.
Result<StudentProgram> studentProgramOf(const QStringList &words,
                                        ShownFiles shown = ShownFiles::WithFolders);

} // namespace pixelplumb
