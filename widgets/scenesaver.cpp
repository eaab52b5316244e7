// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scenesaver.h"

#include <QtConcurrent>

#include <new>
#include <utility>

namespace pixelplumb {

SceneSaver::SceneSaver(QObject *parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &SceneSaver::finish);
}

SceneSaver::~SceneSaver()
{
    if (isRunning())
        m_watcher.waitForFinished();
}

void SceneSaver::save(const QString &path, const std::shared_ptr<const Scene> &scene)
{
    Q_ASSERT(!isRunning());
    m_path = path;
    m_scene = scene;
    m_watcher.setFuture(QtConcurrent::run([path, scene]() -> std::optional<InputError> {
        try {
            return writeSceneFile(path, *scene);
        } catch (const std::bad_alloc &) {
            return InputError{path, tr("the scene's text does not fit into memory"), {}};
        }
    }));
    emit started(path);
}

void SceneSaver::finish()
{
    const std::optional<InputError> error = m_watcher.future().takeResult();
    emit finished(m_path, std::exchange(m_scene, nullptr), error);
}

} // namespace pixelplumb
