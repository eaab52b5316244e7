// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/result.h"

#include <QJsonDocument>
#include <QStringList>

#include <optional>

namespace pixelplumb::cli {

/// How the program ended, for shells and graders.
enum class ExitCode {
    Done = 0, ///< done, or no difference
    FallsShort = 1, ///< differs or falls short
    Usage = 2, ///< a wrong command line or unreadable input
    SizesDiffer = 3,
    Internal = 70,
};

/// The lines as they are printed: UTF-8 whatever the locale, unprintable characters as their codes.
QByteArray shownLines(const QStringList &lines);
/// A result: a line on stdout.
void printLine(const QString &line);
void printLines(const QStringList &lines);
void printJson(const QJsonDocument &document);
/// Flushes what is still buffered. An error where that, or anything before, could not be written: a
/// full disk shows only now.
std::optional<InputError> finishPrinting();
/// A message: a line on stderr, shortened where it is very long.
void sayLine(const QString &line);

} // namespace pixelplumb::cli
