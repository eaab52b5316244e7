// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <optional>

namespace pixelplumb {

/// While one lives, as long as a command runs or a window is open, each file that is read is an
/// input, and no input is written to, by whatever name: its own, a link or a hard link. The record
/// is the process's; several at once are one.
class InputRecord {
public:
    InputRecord();
    ~InputRecord();
    Q_DISABLE_COPY_MOVE(InputRecord)
};

/// Makes a file that is read, or is going to be, an input. An error where standard output or
/// standard error lead to it: it would be changed as it is read.
std::optional<InputError> noteInput(const QString &path);
/// Makes all files that lie in a folder inputs, and in the folders below: what is shown all of them
/// may read any. An error where standard output leads to one that is not empty, and would be
/// changed.
std::optional<InputError> noteInputFolder(const QString &path);
/// The same as noteInput() of the file that standard input leads to.
std::optional<InputError> noteStandardInput();

/// Whether a path leads to an input, or an open descriptor does.
bool isInput(const QString &path);
bool isInput(int descriptor);
/// Why a path is not written to, or standard output; none where it may be.
std::optional<InputError> refusalToWrite(const QString &path);
std::optional<InputError> refusalToPrint();

/// Whether two paths lead to one regular file, through links too; false where one of them does not
/// exist.
bool isSameFile(const QString &path, const QString &other);

} // namespace pixelplumb
