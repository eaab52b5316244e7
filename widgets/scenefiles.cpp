// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenefiles.h"

#include "core/scene/scenefile.h"
#include "widgets/recentfiles.h"
#include "widgets/scenedocument.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
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
{
}

QString SceneFiles::displayName() const
{
    return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).fileName();
}

bool SceneFiles::mayReplace()
{
    if (!m_document->isModified())
        return true;
    switch (askAboutChanges()) {
    case UnsavedChanges::Save:
        return save();
    case UnsavedChanges::Discard:
        return true;
    case UnsavedChanges::Cancel:
        return false;
    }
    return false;
}

bool SceneFiles::load(const QString &path)
{
    const Result<SceneReading> reading = readSceneFile(path);
    if (!reading) {
        const QString message = reading.error().message();
        emit complaint(message.contains(path)
                           ? tr("Not opened: %1").arg(message)
                           : tr("%1 was not opened: %2").arg(QFileInfo(path).fileName(), message));
        return false;
    }
    m_document->reset(reading->scene);
    setPath(path);
    m_recent->add(path);
    emit loaded();
    if (!reading->snaps.empty())
        emit notice(noticeOf(reading->snaps));
    return true;
}

bool SceneFiles::saveTo(const QString &path)
{
    if (const std::optional<InputError> error = writeSceneFile(path, m_document->scene())) {
        emit complaint(tr("The scene was not saved: %1").arg(error->message()));
        return false;
    }
    m_document->markSaved();
    setPath(path);
    m_recent->add(path);
    return true;
}

void SceneFiles::loadDefault()
{
    QFile file(defaultScenePath());
    if (file.open(QIODevice::ReadOnly)) {
        if (const Result<SceneReading> reading = readScene(file.readAll()))
            m_document->reset(reading->scene);
        else
            emit complaint(reading.error().message());
    }
    setPath({});
    emit loaded();
}

bool SceneFiles::showScene(const Scene &scene)
{
    if (!mayReplace())
        return false;
    m_document->reset(scene);
    setPath({});
    emit loaded();
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
    m_document->reset(scene);
    setPath({});
    emit loaded();
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
    if (m_path.isEmpty())
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
