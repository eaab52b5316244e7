// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/job.h"

#include <QDateTime>
#include <QLockFile>
#include <QObject>

#include <optional>

namespace pixelplumb {

class SceneDocument;

/// What a run that did not end cleanly left behind. It is this process's while the lock is held.
struct UnsavedScene {
    QString path; ///< of the kept scene, an ordinary scene file
    QString sceneFile; ///< the person's own, which it was opened from or saved to; may be empty
    QDateTime time; ///< when it was kept
    std::shared_ptr<QLockFile> lock;
};

/// Keeps a document's unsaved scene in a folder of the program's while it differs from what was
/// saved, so that a crash loses seconds. The person's own file is never touched. Each document has
/// a file of its own, locked, so that windows and processes leave each other's alone; nothing is
/// left where the document was saved or given up.
class Autosave : public QObject {
    Q_OBJECT

public:
    static QString defaultFolder();

    Autosave(SceneDocument *document, const QString &folder, QObject *parent = nullptr);
    /// A clean end: nothing is left behind.
    ~Autosave() override;

    /// From a change to its being kept.
    void setRest(std::chrono::milliseconds rest) { m_timer.setInterval(rest); }
    /// The person's own file of the document.
    void setSceneFile(const QString &path);

    /// The latest that was left behind and that no living process holds.
    std::optional<UnsavedScene> leftBehind() const;
    /// The document holds that scene from now on, unsaved.
    void adopt(const UnsavedScene &left);
    static void discard(const UnsavedScene &left);

signals:
    void kept(const QString &path); ///< the file is whole

private:
    struct Writing;

    void followDocument();
    void keep();
    void forget();
    bool lock();

    SceneDocument *m_document;
    QString m_folder;
    QString m_path;
    QString m_sceneFile;
    std::shared_ptr<QLockFile> m_lock; ///< null until there is something to keep
    std::shared_ptr<Writing> m_writing; ///< shared with the worker
    QTimer m_timer;
    Job m_job;
};

} // namespace pixelplumb
