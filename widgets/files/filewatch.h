// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>

namespace pixelplumb {

/// Reports when the followed file changes on disk.
class FileWatch : public QObject {
    Q_OBJECT

public:
    FileWatch();

    /// Follows this file from its present state; none where the path is empty or a resource's.
    void follow(const QString &path);

signals:
    void written();

private:
    void look();

    QString m_path;
    QFileSystemWatcher m_watcher;
    QDateTime m_writtenAt; ///< its time when following began
};

} // namespace pixelplumb
