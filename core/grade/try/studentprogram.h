// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"

#include <QStringList>

namespace pixelplumb {

/// Someone else's program as a command, with absolute paths for the files that it names, since it
/// runs in its own folder.
struct StudentProgram {
    QString path;
    QStringList arguments;
    QStringList shown; ///< its own files and folders that it may read, besides the system's
};

/// Which files named by its command a program may see.
enum class ShownFiles {
    WithFolders, ///< also everything in their folders: modules, tables
    Alone,
};

/// The interpreter of scripts that are not executable. Throws where there is none, which is not the
/// student's fault: the submission is not graded.
QString scriptInterpreter();

/// The program named by the first word (a file, or found in PATH), with the other words as
/// arguments. In the user's own folder, or one shared with others' files, only the file itself is
/// shown. What is shown becomes an input.
Result<StudentProgram> studentProgramOf(const QStringList &words,
                                        ShownFiles shown = ShownFiles::WithFolders);

} // namespace pixelplumb
