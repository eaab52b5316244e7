// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QJsonDocument>
#include <QStringList>

#include <optional>

namespace pixelplumb::cli {

/// How the program ended, for shells and graders.
enum class ExitCode {
    Done = 0, ///< done, or the same
    FallsShort = 1, ///< differs or falls short
    Usage = 2, ///< a wrong command line or unreadable input
    SizesDiffer = 3,
    Internal = 70,
};

/// Lines as they are printed: in UTF-8 whatever the locale, what cannot be shown as its code.
QByteArray shownLines(const QStringList &lines);
/// A result: a line on stdout.
void printLine(const QString &line);
void printLines(const QStringList &lines);
void printJson(const QJsonDocument &document);
/// Writes what is still held back; an error where that, or anything before, could not be written: a
/// full disk shows only now.
std::optional<InputError> finishPrinting();
/// A message: a line on stderr, shortened where it is very long.
void sayLine(const QString &line);

} // namespace pixelplumb::cli
