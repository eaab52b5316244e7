// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/files/inputrecord.h"
#include "widgets/files/examplefolder.h"
#include "widgets/files/recentfiles.h"
#include "widgets/files/scenefiles.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

#include <algorithm>
#include <new>

/// Saves the document to files.
namespace pixelplumb {

namespace {

/// More primitives take too long to write in the GUI thread (about 5 µs each).
constexpr std::size_t mostWrittenAtOnce = 5'000;

} // namespace

QString SceneFiles::titleName() const
{
    const QString mark = u"[*]"_s; // marks changes; doubled, it is literal
    return displayName().replace(mark, mark + mark);
}

QString SceneFiles::baseName() const
{
    return m_path.isEmpty() ? displayName() : QFileInfo(m_path).completeBaseName();
}

bool SceneFiles::save()
{
    return m_path.isEmpty() || isExample(m_path) ? saveAs() : saveTo(m_path);
}

bool SceneFiles::saveAs()
{
    const QString proposal = proposedPath();
    QFileDialog dialog(m_window, tr("Save the Scene"), proposal, sceneFilter());
    dialog.setObjectName(u"saveDialog"_s);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(u"json"_s);
    dialog.selectFile(proposal);
    return dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().constFirst());
}

bool SceneFiles::saveTo(const QString &path)
{
    if (!waitForSaving())
        return false;
    if (!mayBeReplaced(path)) {
        emit complaint(tr("The scene was not saved: %1 was read as something else, such as a "
                          "texture, and would be replaced.")
                           .arg(shownName(path)));
        return false;
    }
    const std::shared_ptr<const Scene> scene = m_document->snapshot();
    if (scene->triangles.size() + scene->solids.size() + scene->shapes.size() > mostWrittenAtOnce) {
        startSaving(path, scene);
        return true;
    }
    const std::optional<InputError> error = writeDocument(path, *scene);
    takeSaved(path, scene, error);
    return !error;
}

/// A file opened as a scene here may be overwritten by saving; any other input may not.
bool SceneFiles::mayBeReplaced(const QString &path) const
{
    return !isInput(path) || std::ranges::any_of(m_documents, [&](const QString &document) {
        return isSameFile(path, document);
    });
}

/// The file is written even when the window closes meanwhile.
void SceneFiles::startSaving(const QString &path, const std::shared_ptr<const Scene> &scene)
{
    m_saving.setTitle(tr("Saving %1").arg(shownName(path)));
    m_saving.start(
        [path, scene](const ProgressListener &) -> std::optional<InputError> {
            try {
                return writeDocument(path, *scene);
            } catch (const std::bad_alloc &) {
                return InputError{path, tr("the scene's text does not fit into memory"), {}};
            }
        },
        [this, path, scene](const std::optional<InputError> &error) {
            takeSaved(path, scene, error);
        });
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

/// Waits until the file is complete; false when the person prefers to go on working.
bool SceneFiles::waitForSaving()
{
    if (!m_saving.isRunning())
        return true;
    QProgressDialog dialog(tr("Saving…"), tr("Go on working"), 0, 0, m_window);
    dialog.setObjectName(u"savingDialog"_s);
    dialog.setWindowModality(Qt::WindowModal);
    connect(&m_saving, &Job::ended, &dialog, &QDialog::accept);
    return dialog.exec() == QDialog::Accepted;
}

/// The scene's own file, or one beside the last file; never among the program's examples.
QString SceneFiles::proposedPath() const
{
    const QString name = m_path.isEmpty() ? u"scene.json"_s : QFileInfo(m_path).fileName();
    const QString proposal = folder() + u'/' + name;
    if (!isExample(proposal))
        return proposal;
    return documentsFolder() + u'/' + name;
}

} // namespace pixelplumb
