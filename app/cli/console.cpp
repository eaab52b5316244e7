// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"

#include "core/grade/showntext.h"
#include "core/scene/inputrecord.h"
#include "core/scene/shortened.h"

#include <cerrno>
#include <cstdio>

namespace pixelplumb::cli {

namespace {

int printFault = 0; ///< errno of the first failure to print; 0: none

/// Writes nothing, not even a refusal, where the stream leads to an input that this would harm.
void writeBytes(std::FILE *stream, const QByteArray &bytes)
{
    if (isInput(fileno(stream)))
        return;
    const auto size = std::size_t(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stream) != size && stream == stdout
        && printFault == 0)
        printFault = errno;
}

} // namespace

QByteArray shownLines(const QStringList &lines)
{
    QByteArray bytes;
    for (const QString &line : lines)
        bytes += escapedControls(line).toUtf8() + '\n';
    return bytes;
}

void printLine(const QString &line) { printLines({line}); }

void printLines(const QStringList &lines) { writeBytes(stdout, shownLines(lines)); }

void printJson(const QJsonDocument &document)
{
    writeBytes(stdout, escapedJson(document.toJson()));
}

std::optional<InputError> finishPrinting()
{
    if (std::fflush(stdout) != 0 && printFault == 0)
        printFault = errno;
    if (printFault == 0 && std::ferror(stdout) == 0)
        return std::nullopt;
    QString what = QStringLiteral("cannot be written");
    if (printFault != 0)
        what += QStringLiteral(": ") + qt_error_string(printFault);
    return InputError{QStringLiteral("standard output"), what, {}};
}

void sayLine(const QString &line)
{
    // A word of a command line may have millions of characters; why it is refused follows it.
    constexpr qsizetype longestHalf = 2000;
    const bool isWhole = line.size() <= 2 * longestHalf;
    writeBytes(
        stderr,
        shownLines({isWhole ? line : shortened(line, longestHalf) + line.last(longestHalf)}));
}

} // namespace pixelplumb::cli
