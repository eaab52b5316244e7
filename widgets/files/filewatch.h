// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFileSystemWatcher>

namespace pixelplumb {

/// Tells when a file is written that was read or written here.
class FileWatch : public QObject {
    Q_OBJECT

public:
    FileWatch();

    /// From now on this one, as it is; none where the path is empty or a resource's.
    void follow(const QString &path);

signals:
    void written();

private:
    void look();

    QString m_path;
    QFileSystemWatcher m_watcher;
    QDateTime m_writtenAt; ///< as it was when following began
};

} // namespace pixelplumb
