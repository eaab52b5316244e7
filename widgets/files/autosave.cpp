// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/files/autosave.h"

#include "core/scene/files/fileaccess.h"
#include "widgets/files/recentfiles.h"
#include "widgets/model/scenedocument.h"

#include <QtWidgets>

#include <mutex>
#include <utility>

namespace pixelplumb {

namespace {

constexpr std::chrono::seconds defaultRest(3);

// Files next to the kept scene, named after it.
QString lockOf(const QString &path) { return path + u".lock"_s; }
QString noteOf(const QString &path) { return path + u".origin"_s; }

std::shared_ptr<QLockFile> lockFor(const QString &path)
{
    auto lock = std::make_shared<QLockFile>(lockOf(path));
    lock->setStaleLockTime(0); // never stale: a living holder may be idle for long
    return lock->tryLock(0) ? lock : nullptr;
}

void removeKept(const QString &path)
{
    QFile::remove(path);
    QFile::remove(noteOf(path));
}

} // namespace

/// Whether a file being written is still wanted when complete: if not, whichever finishes last
/// removes it, so that nobody waits.
struct Autosave::Writing {
    std::mutex mutex;
    bool isWanted = true;
};

QString Autosave::defaultFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + u"/unsaved"_s;
}

Autosave::Autosave(SceneDocument *document, const QString &folder, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_folder(folder)
    , m_path(folder + u'/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + u".json"_s)
    , m_writing(std::make_shared<Writing>())
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(defaultRest);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::keep);
    connect(document, &SceneDocument::sceneChanged, this, &Autosave::followDocument);
    connect(document, &SceneDocument::modifiedChanged, this, &Autosave::followDocument);
}

Autosave::~Autosave() { forget(); }

void Autosave::forget()
{
    if (!m_lock)
        return;
    m_job.cancel();
    const std::shared_ptr<Writing> writing = std::exchange(m_writing, std::make_shared<Writing>());
    const std::lock_guard guard(writing->mutex);
    writing->isWanted = false;
    removeKept(m_path);
}

void Autosave::setSceneFile(const QString &path) { m_sceneFile = path; }

void Autosave::followDocument()
{
    if (m_document->isModified()) {
        if (!m_timer.isActive()) // so that a long drag is kept, too
            m_timer.start();
        return;
    }
    m_timer.stop();
    forget();
}

bool Autosave::lock()
{
    if (!m_lock && QDir().mkpath(m_folder))
        m_lock = lockFor(m_path);
    return m_lock != nullptr;
}

/// Fails silently: it would complain every few seconds.
void Autosave::keep()
{
    if (!m_document->isModified() || !lock())
        return;
    m_job.start(
        [scene = m_document->snapshot(), path = m_path, sceneFile = m_sceneFile, lock = m_lock,
         writing = m_writing](const ProgressListener &) {
            const bool isWritten = !writeFile(noteOf(path), sceneFile.toUtf8(), WrittenAs::Document)
                && !writeDocument(path, *scene);
            const std::lock_guard guard(writing->mutex);
            if (!writing->isWanted)
                removeKept(path);
            return isWritten && writing->isWanted;
        },
        [this](bool isKept) {
            if (isKept)
                emit kept(m_path);
        });
}

std::optional<UnsavedScene> Autosave::leftBehind() const
{
    const QDir folder(m_folder);
    for (const QFileInfo &file : folder.entryInfoList({u"*.json"_s}, QDir::Files, QDir::Time)) {
        const QString path = file.filePath();
        if (path == m_path)
            continue;
        const std::shared_ptr<QLockFile> lock = lockFor(path);
        if (!lock || !QFile::exists(path)) // its window still lives, or has just ended
            continue;
        const auto note = readRegularFile(noteOf(path));
        return UnsavedScene{path, note ? QString::fromUtf8(*note) : QString(), file.lastModified(),
                            lock};
    }
    return std::nullopt;
}

void Autosave::adopt(const UnsavedScene &left)
{
    forget();
    m_path = left.path;
    m_lock = left.lock;
    m_document->markUnsaved();
}

void Autosave::discard(const UnsavedScene &left) { removeKept(left.path); }

} // namespace pixelplumb
