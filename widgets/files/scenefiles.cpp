// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/scenefiles.h"

#include "core/grade/class/assignment.h"
#include "core/scene/fields/referredfiles.h"
#include "core/scene/files/inputrecord.h"
#include "core/scene/scenefile.h"
#include "widgets/files/recentfiles.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/runnotes.h"
#include "widgets/model/scenedocument.h"

namespace pixelplumb {

namespace {

struct ChangesQuestion {
    Q_DECLARE_TR_FUNCTIONS(pixelplumb::UnsavedChanges)
};

UnsavedChanges ask(const QString &name, QMessageBox::StandardButtons answers, QWidget *window)
{
    QMessageBox box(QMessageBox::Question, ChangesQuestion::tr("Unsaved Changes"),
                    ChangesQuestion::tr("“%1” has changes that are not saved.").arg(name), answers,
                    window);
    box.setObjectName(u"unsavedChanges"_s);
    box.setTextFormat(Qt::PlainText); // a name may look like HTML
    box.setInformativeText(ChangesQuestion::tr("Without saving they are lost."));
    box.setDefaultButton(answers & QMessageBox::Save ? QMessageBox::Save : QMessageBox::Cancel);
    switch (box.exec()) {
    case QMessageBox::Save:
        return UnsavedChanges::Save;
    case QMessageBox::Discard:
        return UnsavedChanges::Discard;
    default:
        return UnsavedChanges::Cancel;
    }
}

/// Bytes. Larger files take too long to read in the GUI thread (about 16 µs per triangle).
constexpr qint64 largestReadAtOnce = qint64(1) << 18;

} // namespace

UnsavedChanges askAboutChanges(const QString &name, QWidget *window)
{
    return ask(name, QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window);
}

UnsavedChanges askAboutRevert(const QString &name, QWidget *window)
{
    return ask(name, QMessageBox::Discard | QMessageBox::Cancel, window);
}

QString SceneFiles::defaultScenePath() { return u":/scenes/default.json"_s; }

QString SceneFiles::sceneFilter() { return tr("Scenes (*.json *.pixelplumb);;All files (*)"); }

SceneFiles::SceneFiles(SceneDocument *document, RecentFiles *recent, QWidget *window)
    : QObject(window)
    , askAboutChanges([this] { return pixelplumb::askAboutChanges(displayName(), m_window); })
    , askAboutRevert([this] { return pixelplumb::askAboutRevert(displayName(), m_window); })
    , m_document(document)
    , m_recent(recent)
    , m_window(window)
{
    connect(&m_watch, &FileWatch::written, this, [this] {
        if (m_saving.isRunning())
            return;
        emit notice(tr("Another program has written %1: File ▸ Revert to the file reads it again.")
                        .arg(displayName()));
    });
}

QString SceneFiles::displayName() const
{
    return m_path.isEmpty() ? tr("untitled") : shownName(m_path);
}

bool SceneFiles::mayReplace()
{
    if (!waitForSaving())
        return false;
    if (!m_document->isModified())
        return true;
    switch (askAboutChanges()) {
    case UnsavedChanges::Save:
        return save() && waitForSaving() && !m_document->isModified();
    case UnsavedChanges::Discard:
        return true;
    case UnsavedChanges::Cancel:
        return false;
    }
    return false;
}

void SceneFiles::readBeside(const QString &path, const QString &title,
                            const std::function<void(Reading &reading)> &take)
{
    m_editsAtLoad = m_document->undoStack()->index();
    m_loading.setTitle(title);
    m_loading.start(
        [path](const ProgressListener &listener) {
            return std::make_shared<Reading>(readSceneFile(path, listener));
        },
        [path, take](const std::shared_ptr<Reading> &reading) {
            Reading tooLarge = InputError{path, tr("the scene does not fit into memory"), {}};
            take(reading ? *reading : tooLarge);
        });
}

void SceneFiles::recover(const QString &path, const std::function<void()> &shown)
{
    const auto take = [this, path, shown](Reading &reading) {
        if (!reading)
            complainOf(path, reading.error().message());
        else if (showScene(reading->scene))
            return shown();
        emit loadingFailed();
    };
    if (bytesToRead(path) > largestReadAtOnce)
        return readBeside(path, tr("Recovering the unsaved scene"), take);
    Reading reading = readSceneFile(path);
    take(reading);
}

bool SceneFiles::load(const QString &path)
{
    if (bytesToRead(path) > largestReadAtOnce) {
        readBeside(path, tr("Opening %1").arg(shownName(path)),
                   [this, path](Reading &reading) { takeLoaded(path, reading); });
        return true;
    }
    Result<SceneReading> reading = readSceneFile(path);
    if (!reading) {
        complainOf(path, reading.error().message());
        return false;
    }
    show(path, *reading);
    return true;
}

void SceneFiles::cancelLoading()
{
    if (!isLoading())
        return;
    m_loading.cancel();
    emit loadingFailed();
}

void SceneFiles::takeLoaded(const QString &path, Result<SceneReading> &reading)
{
    if (!reading) {
        complainOf(path, reading.error().message());
        emit loadingFailed();
        return;
    }
    // The old document may have been edited meanwhile.
    const bool wasEdited = m_document->undoStack()->index() != m_editsAtLoad;
    if (wasEdited && !mayReplace()) {
        emit loadingFailed();
        return;
    }
    show(path, *reading);
}

void SceneFiles::complainOf(const QString &path, const QString &message)
{
    if (kindOfFile(path) == FileKind::Assignment) {
        emit assignmentMet(path);
        return;
    }
    emit complaint(message.contains(path)
                       ? tr("Not opened: %1").arg(message)
                       : tr("%1 was not opened: %2").arg(shownName(path), message));
}

void SceneFiles::show(const QString &path, SceneReading &reading)
{
    replaceBy(std::move(reading.scene), path);
    m_recent->add(path);
    if (!reading.snaps.empty())
        emit notice(snapNote(reading.snaps));
}

/// Cancels any other reading.
void SceneFiles::replaceBy(Scene scene, const QString &path)
{
    cancelLoading();
    emit replacing();
    m_document->reset(std::move(scene));
    setPath(path);
    emit loaded();
}

void SceneFiles::loadDefault()
{
    QFile file(defaultScenePath());
    if (file.open(QIODevice::ReadOnly)) {
        Result<SceneReading> reading = readScene(file.readAll());
        if (!reading) {
            emit complaint(reading.error().message());
            return;
        }
        replaceBy(std::move(reading->scene), {});
    }
}

bool SceneFiles::showScene(const Scene &scene)
{
    if (!mayReplace())
        return false;
    replaceBy(scene, {});
    return true;
}

void SceneFiles::newScene()
{
    if (!mayReplace())
        return;
    Scene scene;
    scene.frame = m_document->scene().frame;
    scene.settings = m_document->scene().settings;
    scene.settings.variants = {}; // a new scene starts without defects
    scene.method = m_document->scene().method;
    replaceBy(std::move(scene), {});
    emit begun();
}

void SceneFiles::open()
{
    if (!mayReplace())
        return;
    const QString path
        = QFileDialog::getOpenFileName(m_window, tr("Open a Scene"), folder(), sceneFilter());
    if (!path.isEmpty())
        load(path);
}

void SceneFiles::openFile(const QString &path)
{
    if (mayReplace())
        load(path);
}

void SceneFiles::revert()
{
    if (m_path.isEmpty() || !waitForSaving())
        return;
    if (m_document->isModified() && askAboutRevert() != UnsavedChanges::Discard)
        return;
    load(m_path);
}

QString SceneFiles::folder() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).absolutePath();
    if (!m_recent->paths().isEmpty()) {
        const QString last = QFileInfo(m_recent->paths().constFirst()).absolutePath();
        if (QFileInfo(last).isDir())
            return last;
    }
    return documentsFolder();
}

void SceneFiles::setPath(const QString &path)
{
    m_path = path;
    if (!path.isEmpty() && !m_documents.contains(path))
        m_documents += path;
    noteInput(path); // an input of exports, even if never read
    m_watch.follow(path);
    emit pathChanged();
}

} // namespace pixelplumb
