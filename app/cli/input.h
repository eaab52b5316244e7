// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/fileaccess.h"

namespace pixelplumb::cli {

/// Reads a file, or stdin for "-", up to `most` bytes. Commands read all their input files with it.
/// It refuses a file to which standard output is appended (`trace s.json >> s.json`), since every
/// command may write there; nothing is written before that.
Result<QByteArray> readInput(const QString &path, qint64 most = largestFile);

/// The folder in which an input's relative references are looked up: its own; empty, the current
/// one, for "-".
QString folderOf(const QString &path);

} // namespace pixelplumb::cli
