// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"
#include "core/scene/scene.h"
#include "core/scene/text/result.h"

#include <QtWidgets>

#include <optional>
#include <variant>

namespace pixelplumb {

/// The scenes opened or saved last, newest first, kept in QSettings; as a menu.
class RecentFiles : public QObject {
    Q_OBJECT

public:
    static constexpr qsizetype most = 10;

    explicit RecentFiles(QObject *parent = nullptr);

    QStringList paths() const { return m_paths; }
    /// The menu refills whenever it is opened; files that are gone are grey. It is grey itself
    /// while there are none.
    QMenu *createMenu(QWidget *parent);

public slots:
    void add(const QString &path);
    void clear();

signals:
    void chosen(const QString &path);
    void changed();

private:
    void store();
    void fill(QMenu *menu);

    QStringList m_paths;
};

/// Where the playhead starts in a scene that was opened.
enum class OpeningMoment {
    HalfDrawn, ///< on entering the second column past the middle vertex
    Finished,
};
/// On entering the column at x.
struct OpeningColumn {
    std::int64_t x = 0;
};
using OpeningPlace = std::variant<OpeningMoment, std::size_t, OpeningColumn>;

/// The position of a place in a run; the end where the run lacks that place.
std::size_t positionOf(const OpeningPlace &place, const ScanTrace &trace);

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

/// Writes the current scene to its own file, from which it was read.
std::optional<InputError> writeDocument(const QString &path, const Scene &scene);

/// Where a scene without a folder is saved: the person's documents, or home where there is no such
/// folder. Absolute and existing: a file dialog takes no proposal in a folder that does not exist.
QString documentsFolder();

} // namespace pixelplumb
