// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/filewatch.h"

#include <QFileInfo>

namespace pixelplumb {

FileWatch::FileWatch()
{
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::look);
}

void FileWatch::follow(const QString &path)
{
    m_path = path;
    if (const QStringList watched = m_watcher.files(); !watched.isEmpty())
        m_watcher.removePaths(watched);
    const bool isInFolder = !path.isEmpty() && !path.startsWith(u':');
    m_writtenAt = isInFolder ? QFileInfo(path).lastModified() : QDateTime();
    if (m_writtenAt.isValid())
        m_watcher.addPath(path);
}

void FileWatch::look()
{
    const QDateTime writtenAt = QFileInfo(m_path).lastModified();
    if (!writtenAt.isValid() || writtenAt == m_writtenAt)
        return;
    follow(m_path); // a file that replaced it is another file
    emit written();
}

} // namespace pixelplumb
