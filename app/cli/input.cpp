// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input.h"

#include "core/scene/inputrecord.h"

#include <QFile>
#include <QFileInfo>

#include <cstdio>

namespace pixelplumb::cli {

Result<QByteArray> readInput(const QString &path, qint64 most)
{
    if (path.isEmpty())
        return InputError{QStringLiteral("“”"), QStringLiteral("names no file"),
                          QStringLiteral("the name of one, or - for standard input")};
    if (path != QStringLiteral("-"))
        return readFile(path, most);
    const QString place = QStringLiteral("standard input");
    if (auto refusal = noteStandardInput())
        return *refusal;
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly))
        return InputError{place, input.errorString(), {}};
    return readDevice(place, input, most);
}

QString folderOf(const QString &path)
{
    return path == QStringLiteral("-") ? QString() : QFileInfo(path).absolutePath();
}

} // namespace pixelplumb::cli
