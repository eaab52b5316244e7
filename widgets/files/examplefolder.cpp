// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/examplefolder.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace pixelplumb {

bool isExample(const QString &path)
{
    const QString folder = QFileInfo(path).dir().canonicalPath();
    if (folder.isEmpty())
        return false;
    QDir above(QCoreApplication::applicationDirPath());
    do {
        for (const char *scenes : {"resources/scenes", "share/pixelplumb/scenes"}) {
            if (QDir(above.filePath(QString::fromLatin1(scenes))).canonicalPath() == folder)
                return true;
        }
    } while (above.cdUp());
    return false;
}

} // namespace pixelplumb
