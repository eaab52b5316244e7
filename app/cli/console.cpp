// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console.h"

#include "core/grade/showntext.h"

#include <cstdio>

namespace pixelplumb::cli {

namespace {

void writeLine(std::FILE *stream, const QString &line)
{
    const QByteArray bytes = line.toUtf8() + '\n';
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stream);
}

} // namespace

void printLine(const QString &line) { writeLine(stdout, line); }

void printLines(const QStringList &lines)
{
    for (const QString &line : lines)
        printLine(line);
}

void printJson(const QJsonDocument &document)
{
    printLine(QString::fromUtf8(document.toJson().chopped(1)));
}

void sayLine(const QString &line) { writeLine(stderr, escapedControls(line)); }

} // namespace pixelplumb::cli
