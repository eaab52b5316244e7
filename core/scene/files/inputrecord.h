// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/text/result.h"

#include <optional>

namespace pixelplumb {

/// While one lives, which is as long as a command runs or a window is open, every file that is read
/// is an input, and no input is written to under any name: its own, a link or a hard link. The
/// record belongs to the process; several at once share it.
class InputRecord {
public:
    InputRecord();
    ~InputRecord();
    Q_DISABLE_COPY_MOVE(InputRecord)
};

/// Records a file that is read, or about to be, as an input. An error where standard output or
/// standard error leads to it: it would change while it is read.
std::optional<InputError> noteInput(const QString &path);
/// Records all files in a folder and in the folders below it as inputs, since a program that sees
/// the folder may read any of them. An error where standard output leads to one that is not empty:
/// it would be changed.
std::optional<InputError> noteInputFolder(const QString &path);
/// Like noteInput(), for the file that standard input leads to.
std::optional<InputError> noteStandardInput();

/// An error where standard output or standard error leads to an open file that is read without
/// being recorded: it would change meanwhile.
std::optional<InputError> refusalToRead(int descriptor);

/// Whether a path, or an open descriptor, leads to an input.
bool isInput(const QString &path);
bool isInput(int descriptor);
/// Why a path, or standard output, must not be written to; none where it may be.
std::optional<InputError> refusalToWrite(const QString &path);
std::optional<InputError> refusalToPrint();

/// Whether two paths lead to the same regular file, also through links; false where one of them
/// does not exist.
bool isSameFile(const QString &path, const QString &other);

} // namespace pixelplumb
