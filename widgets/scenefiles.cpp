// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenefiles.h"

#include "core/scene/scenefile.h"
#include "widgets/recentfiles.h"
#include "widgets/scenedocument.h"
#include "widgets/sceneloader.h"
#include "widgets/scenesaver.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QStandardPaths>

namespace pixelplumb {

namespace {

QString sceneFilter() { return SceneFiles::tr("Scenes (*.json);;All files (*)"); }

/// Displacements of the coordinates that were not on the lattice: an error of the input, told once.
QString noticeOf(const std::vector<SnapReport> &snaps)
{
    constexpr std::size_t mostLines = 3;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(snaps.size(), mostLines); ++i)
        lines += snaps[i].message();
    if (snaps.size() > mostLines)
        lines += SceneFiles::tr("and %n more coordinate(s) are drawn at multiples of 1/256 px",
                                nullptr, int(snaps.size() - mostLines));
    return lines.join(QLatin1Char('\n'));
}

} // namespace

QString SceneFiles::defaultScenePath() { return QStringLiteral(":/scenes/default.json"); }

SceneFiles::SceneFiles(SceneDocument *document, RecentFiles *recent, QWidget *window)
    : QObject(window)
    , askAboutChanges(
          [this] { return ask(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel); })
    , askAboutRevert([this] { return ask(QMessageBox::Discard | QMessageBox::Cancel); })
    , m_document(document)
    , m_recent(recent)
    , m_window(window)
    , m_loader(new SceneLoader(this))
    , m_saver(new SceneSaver(this))
{
    connect(m_saver, &SceneSaver::finished, this, &SceneFiles::takeSaved);
    connect(m_loader, &SceneLoader::finished, this, &SceneFiles::takeLoaded);
    connect(m_loader, &SceneLoader::cancelled, this, &SceneFiles::loadingFailed);
}

QString SceneFiles::displayName() const
{
    return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).fileName();
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

bool SceneFiles::load(const QString &path)
{
    if (SceneLoader::isLarge(path)) {
        m_editsAtLoad = m_document->undoStack()->index();
        m_loader->load(path);
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

bool SceneFiles::isLoading() const { return m_loader->isRunning(); }

void SceneFiles::takeLoaded(const QString &path,
                            const std::shared_ptr<Result<SceneReading>> &reading)
{
    if (!*reading) {
        complainOf(path, reading->error().message());
        emit loadingFailed();
        return;
    }
    // The old document could be edited meanwhile.
    const bool wasEdited = m_document->undoStack()->index() != m_editsAtLoad;
    if (wasEdited && !mayReplace()) {
        emit loadingFailed();
        return;
    }
    show(path, **reading);
}

void SceneFiles::complainOf(const QString &path, const QString &message)
{
    emit complaint(message.contains(path)
                       ? tr("Not opened: %1").arg(message)
                       : tr("%1 was not opened: %2").arg(QFileInfo(path).fileName(), message));
}

void SceneFiles::show(const QString &path, SceneReading &reading)
{
    replaceBy(std::move(reading.scene), path);
    m_recent->add(path);
    if (!reading.snaps.empty())
        emit notice(noticeOf(reading.snaps));
}

/// Whatever else was being read is not wanted any more.
void SceneFiles::replaceBy(Scene scene, const QString &path)
{
    m_loader->cancel();
    m_document->reset(std::move(scene));
    setPath(path);
    emit loaded();
}

bool SceneFiles::saveTo(const QString &path)
{
    if (!waitForSaving())
        return false;
    const std::shared_ptr<const Scene> scene = m_document->snapshot();
    if (SceneSaver::isLarge(*scene)) {
        m_saver->save(path, scene);
        return true;
    }
    const std::optional<InputError> error = writeSceneFile(path, *scene);
    takeSaved(path, scene, error);
    return !error;
}

void SceneFiles::takeSaved(const QString &path, const std::shared_ptr<const Scene> &scene,
                           const std::optional<InputError> &error)
{
    if (error) {
        emit complaint(tr("The scene was not saved: %1").arg(error->message()));
        return;
    }
    if (m_document->snapshot() == scene) // else it was edited meanwhile
        m_document->markSaved();
    setPath(path);
    m_recent->add(path);
}

/// Until the file that is being written is whole; false when the person would rather go on.
bool SceneFiles::waitForSaving()
{
    if (!m_saver->isRunning())
        return true;
    QProgressDialog dialog(tr("Saving…"), tr("Go on working"), 0, 0, m_window);
    dialog.setObjectName(QStringLiteral("savingDialog"));
    dialog.setWindowModality(Qt::WindowModal);
    connect(m_saver, &SceneSaver::finished, &dialog, &QDialog::accept);
    return dialog.exec() == QDialog::Accepted;
}

void SceneFiles::loadDefault()
{
    QFile file(defaultScenePath());
    if (file.open(QIODevice::ReadOnly)) {
        if (Result<SceneReading> reading = readScene(file.readAll()))
            replaceBy(std::move(reading->scene), {});
        else
            emit complaint(reading.error().message());
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
    scene.method = m_document->scene().method;
    replaceBy(std::move(scene), {});
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

bool SceneFiles::save() { return m_path.isEmpty() ? saveAs() : saveTo(m_path); }

bool SceneFiles::saveAs()
{
    const QString proposal = m_path.isEmpty() ? folder() + QStringLiteral("/scene.json") : m_path;
    QFileDialog dialog(m_window, tr("Save the Scene"), proposal, sceneFilter());
    dialog.setObjectName(QStringLiteral("saveDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    dialog.selectFile(proposal);
    return dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().constFirst());
}

void SceneFiles::revert()
{
    if (m_path.isEmpty() || !waitForSaving())
        return;
    // Saving first would leave nothing to revert to.
    if (m_document->isModified() && askAboutRevert() != UnsavedChanges::Discard)
        return;
    load(m_path);
}

UnsavedChanges SceneFiles::ask(int answers) const
{
    QMessageBox box(QMessageBox::Question, tr("Unsaved Changes"),
                    tr("“%1” has changes that are not saved.").arg(displayName()),
                    QMessageBox::StandardButtons(answers), m_window);
    box.setObjectName(QStringLiteral("unsavedChanges"));
    box.setInformativeText(tr("Without saving they are lost."));
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

QString SceneFiles::folder() const
{
    if (!m_path.isEmpty())
        return QFileInfo(m_path).absolutePath();
    if (!m_recent->paths().isEmpty())
        return QFileInfo(m_recent->paths().constFirst()).absolutePath();
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void SceneFiles::setPath(const QString &path)
{
    m_path = path;
    emit pathChanged();
}

} // namespace pixelplumb
