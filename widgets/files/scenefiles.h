// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scenefile.h"
#include "widgets/files/recentfiles.h"
#include "widgets/model/job.h"

#include <QtWidgets>

#include <functional>
#include <memory>

namespace pixelplumb {

class RecentFiles;
class SceneDocument;

/// What to do with changes that are not in a file yet.
enum class UnsavedChanges { Save, Discard, Cancel };

/// Asks in a box before the named scene is replaced: any of the three.
UnsavedChanges askAboutChanges(const QString &name, QWidget *window);
/// Asks before going back to the file: Discard or Cancel; saving first would leave nothing to go
/// back to.
UnsavedChanges askAboutRevert(const QString &name, QWidget *window);

/// The document's life as a file: new, open, save, and the question before changes are lost. Large
/// files are read in a worker thread; the old document stays until the new one is complete. Large
/// scenes are written there too; nothing replaces the document before its file is complete.
class SceneFiles : public QObject {
    Q_OBJECT

public:
    /// The scene with which the program starts.
    static QString defaultScenePath();

    SceneFiles(SceneDocument *document, RecentFiles *recent, QWidget *window);

    /// Empty when the scene has no file yet.
    QString path() const { return m_path; }
    /// The file's name, or "untitled".
    QString displayName() const;
    QString titleName() const; ///< displayName() for a window's title
    /// The file's name without its ending, or "untitled"; exports are named after it.
    QString baseName() const;

    /// True when the document may be replaced: nothing is unsaved, or it was saved now or given up.
    bool mayReplace();
    /// Opens without asking. False after a complaint; the document is then untouched. A large file
    /// is still loading while isLoading(); loaded() reports that it is open.
    bool load(const QString &path);
    bool isLoading() const { return m_loading.isRunning(); }
    const Job &loading() const { return m_loading; }
    const Job &saving() const { return m_saving; }
    /// False after a complaint. A large scene is saved once the document reports itself unmodified.
    bool saveTo(const QString &path);
    void loadDefault();
    /// Shows a kept file as a scene without a file, then calls `shown`; a person may refuse and
    /// keep the current scene.
    void recover(const QString &path, const std::function<void()> &shown);
    /// Shows a scene that is in no file; false when the person keeps the current one.
    bool showScene(const Scene &scene);

    /// Asks before changes are lost; a test answers by replacing the function.
    std::function<UnsavedChanges()> askAboutChanges;
    /// Asks before going back to the file: Discard or Cancel.
    std::function<UnsavedChanges()> askAboutRevert;

public slots:
    void cancelLoading();
    void newScene();
    void open();
    void openFile(const QString &path);
    /// Saves to the scene's own file; for an example, asks where.
    bool save();
    bool saveAs();
    void revert(); ///< to what the file says

signals:
    /// Another scene, unrelated to the current one, is about to enter the document.
    void replacing();
    void pathChanged();
    void loaded();
    void begun(); ///< after loaded(): the scene is empty and drawing begins
    void loadingFailed(); ///< after a complaint or a cancel: the document is unchanged
    void complaint(const QString &text);
    /// Not opened, because the file is no scene but an assignment, which grading takes.
    void assignmentMet(const QString &path);
    void notice(const QString &text);

private:
    static QString sceneFilter(); ///< of the dialogs
    QString folder() const;
    QString proposedPath() const;
    void setPath(const QString &path);
    using Reading = Result<SceneReading>;
    void readBeside(const QString &path, const QString &title,
                    const std::function<void(Reading &reading)> &take);
    void takeLoaded(const QString &path, Result<SceneReading> &reading);
    void show(const QString &path, SceneReading &reading);
    void replaceBy(Scene scene, const QString &path);
    void startSaving(const QString &path, const std::shared_ptr<const Scene> &scene);
    bool waitForSaving();
    bool mayBeReplaced(const QString &path) const;
    void takeSaved(const QString &path, const std::shared_ptr<const Scene> &scene,
                   const std::optional<InputError> &error);
    void complainOf(const QString &path, const QString &message);

    SceneDocument *m_document;
    RecentFiles *m_recent;
    QWidget *m_window;
    Job m_loading; ///< of a large file, until a newer one is asked for
    Job m_saving; ///< of a large scene
    int m_editsAtLoad = 0; ///< the undo stack's place when the reading began
    QString m_path;
    QStringList m_documents; ///< every value that m_path had
    FileWatch m_watch; ///< of m_path
};

} // namespace pixelplumb
