// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonDocument>
#include <QStringList>

namespace pixelplumb::cli {

/// How the program ended, for shells and graders.
enum class ExitCode {
    Done = 0, ///< done, or the same
    FallsShort = 1, ///< differs or falls short
    Usage = 2, ///< a wrong command line or unreadable input
    SizesDiffer = 3,
    Internal = 70,
};

/// A result: a line on stdout, in UTF-8 whatever the locale.
void printLine(const QString &line);
void printLines(const QStringList &lines);
void printJson(const QJsonDocument &document);
/// A message: a line on stderr.
void sayLine(const QString &line);

} // namespace pixelplumb::cli
