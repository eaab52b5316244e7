// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/model/job.h"

#include <QtCore>

#include <optional>

namespace pixelplumb {

class SceneDocument;

/// What a run that did not end cleanly left behind. It belongs to this process while the lock is
/// held.
struct UnsavedScene {
    QString path; ///< of the kept scene, an ordinary scene file
    QString sceneFile; ///< the person's own file, opened or saved last; may be empty
    QDateTime time; ///< when it was kept
    std::shared_ptr<QLockFile> lock;
};

/// Keeps a document's unsaved scene in a folder of the program while it differs from the saved one,
/// so that a crash loses only seconds. The person's own file is never touched. Each document has
/// its own locked file, so that windows and processes do not disturb each other; nothing is left
/// once the document is saved or given up.
class Autosave : public QObject {
    Q_OBJECT

public:
    static QString defaultFolder();

    Autosave(SceneDocument *document, const QString &folder, QObject *parent = nullptr);
    /// A clean end: nothing is left behind.
    ~Autosave() override;

    /// The delay between a change and its being kept.
    void setRest(std::chrono::milliseconds rest) { m_timer.setInterval(rest); }
    /// Sets the person's own file of the document.
    void setSceneFile(const QString &path);

    /// The latest scene left behind that no living process holds.
    std::optional<UnsavedScene> leftBehind() const;
    /// To be called when the document now holds that scene, unsaved.
    void adopt(const UnsavedScene &left);
    static void discard(const UnsavedScene &left);

signals:
    void kept(const QString &path); ///< the file is complete

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
