// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fileaccess.h"

namespace pixelplumb::cli {

/// The content of a file, or of stdin for "-", of at most so many bytes. Every input that a command
/// line names is read by it, and every command writes to standard output or may: a file that
/// standard output would be added to (`trace s.json >> s.json`) is refused before anything is
/// written.
Result<QByteArray> readInput(const QString &path, qint64 most = largestFile);

/// Where the files that an input refers to are found: in its own folder; empty, the current one,
/// for "-".
QString folderOf(const QString &path);

} // namespace pixelplumb::cli
