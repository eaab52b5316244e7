// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>

class QWidget;

namespace pixelplumb {

class RecentFiles;
class SceneDocument;
struct Scene;

/// What to do with changes that are not in a file yet.
enum class UnsavedChanges { Save, Discard, Cancel };

/// The document's life as a file: new, open, save, and the question before changes are lost.
class SceneFiles : public QObject {
    Q_OBJECT

public:
    /// The scene with which the program starts and "new" begins.
    static QString defaultScenePath();

    SceneFiles(SceneDocument *document, RecentFiles *recent, QWidget *window);

    /// Empty when the scene has no file yet.
    QString path() const { return m_path; }
    /// The file's name, or "untitled".
    QString displayName() const;

    /// True when the document may be replaced: nothing unsaved, or saved now, or given up.
    bool mayReplace();
    /// Opens without asking. False after a complaint; then the document is untouched.
    bool load(const QString &path);
    bool saveTo(const QString &path);
    void loadDefault();
    /// A scene that is in no file; false when the person keeps the one that is there.
    bool showScene(const Scene &scene);

    /// The question before changes are lost; a test answers it by replacing the function.
    std::function<UnsavedChanges()> askAboutChanges;
    /// The same before going back to the file: Discard or Cancel.
    std::function<UnsavedChanges()> askAboutRevert;

public slots:
    void newScene();
    void open();
    void openFile(const QString &path);
    bool save();
    bool saveAs();
    void revert(); ///< to what the file says

signals:
    void pathChanged();
    void loaded();
    void complaint(const QString &text);
    void notice(const QString &text);

private:
    UnsavedChanges ask(int answers) const; ///< of QMessageBox::StandardButton
    QString folder() const;
    void setPath(const QString &path);

    SceneDocument *m_document;
    RecentFiles *m_recent;
    QWidget *m_window;
    QString m_path;
};

} // namespace pixelplumb
