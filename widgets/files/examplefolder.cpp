// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/examplefolder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace pixelplumb {

namespace {

/// Of the sources and of an installed program, nearest first.
QList<QDir> exampleFolders()
{
    QList<QDir> folders;
    QDir above(QCoreApplication::applicationDirPath());
    do {
        for (const char *scenes : {"resources/scenes", "share/pixelplumb/scenes"}) {
            const QDir folder(above.filePath(QString::fromLatin1(scenes)));
            if (folder.exists())
                folders.append(folder);
        }
    } while (above.cdUp());
    return folders;
}

} // namespace

bool isExample(const QString &path)
{
    const QString folder = QFileInfo(path).dir().canonicalPath();
    if (folder.isEmpty())
        return false;
    for (const QDir &examples : exampleFolders()) {
        if (examples.canonicalPath() == folder)
            return true;
    }
    return false;
}

QStringList examplePaths()
{
    QStringList paths;
    const QList<QDir> folders = exampleFolders();
    if (folders.isEmpty())
        return paths;
    for (const QString &name : folders.front().entryList({QStringLiteral("*.json")}, QDir::Files))
        paths.append(folders.front().filePath(name));
    return paths;
}

} // namespace pixelplumb
