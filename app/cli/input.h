// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QByteArray>

namespace pixelplumb::cli {

/// The content of a file, or of stdin for "-". Every input of every command is read by it, and
/// every command writes to standard output or may: a file that standard output would be added to
/// (`trace s.json >> s.json`) is refused before anything is written.
Result<QByteArray> readInput(const QString &path);

} // namespace pixelplumb::cli
