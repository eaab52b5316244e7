// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"

#include "core/grade/showntext.h"
#include "core/scene/inputrecord.h"
#include "core/scene/shortened.h"

#include <cstdio>

namespace pixelplumb::cli {

namespace {

/// Where a stream leads to an input it would harm it: even a refusal is kept back.
void writeBytes(std::FILE *stream, const QByteArray &bytes)
{
    if (isInput(fileno(stream)))
        return;
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stream);
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

void sayLine(const QString &line)
{
    constexpr qsizetype longestLine
        = 4000; // characters; a word of a command line may have millions
    writeBytes(stderr, shownLines({shortened(line, longestLine)}));
}

} // namespace pixelplumb::cli
