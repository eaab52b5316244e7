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
};

/// The program that the first word names (a file, or what PATH holds), with the other words. The
/// files that they name are inputs from then on.
Result<StudentProgram> studentProgramOf(const QStringList &words);

} // namespace pixelplumb
