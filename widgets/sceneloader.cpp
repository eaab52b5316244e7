// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneloader.h"

#include <QFileInfo>
#include <QtConcurrent>

#include <chrono>
#include <new>
#include <utility>

namespace pixelplumb {

namespace {

using namespace std::chrono_literals;

InputError tooLargeForMemory(const QString &path)
{
    return {path, SceneLoader::tr("the scene does not fit into memory"), {}};
}

} // namespace

SceneLoader::SceneLoader(QObject *parent)
    : QObject(parent)
{
    m_progressTimer.setInterval(50ms);
    connect(&m_progressTimer, &QTimer::timeout, this, [this] { emit progressChanged(m_percent); });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &SceneLoader::finish);
}

SceneLoader::~SceneLoader()
{
    m_cancelled = true;
    if (isRunning())
        m_watcher.waitForFinished();
}

bool SceneLoader::isLarge(const QString &path)
{
    return QFileInfo(path).size() > largestReadAtOnce;
}

void SceneLoader::load(const QString &path)
{
    if (m_path.isEmpty()) {
        start(path);
        return;
    }
    m_cancelled = true;
    m_next = path;
}

void SceneLoader::cancel()
{
    m_next.clear();
    m_cancelled = true;
}

void SceneLoader::start(const QString &path)
{
    m_path = path;
    m_cancelled = false;
    m_percent = 0;
    ReadOptions options;
    options.progress = [this](qsizetype bytesRead, qsizetype bytes) {
        m_percent = int(100 * bytesRead / std::max<qsizetype>(1, bytes));
        return !m_cancelled;
    };
    m_watcher.setFuture(QtConcurrent::run([path, options] {
        try {
            return std::make_shared<Result<SceneReading>>(readSceneFile(path, options));
        } catch (const std::bad_alloc &) {
            return std::make_shared<Result<SceneReading>>(tooLargeForMemory(path));
        }
    }));
    m_progressTimer.start();
    emit started(path);
}

void SceneLoader::finish()
{
    m_progressTimer.stop();
    const Reading reading = m_watcher.future().takeResult();
    const QString path = std::exchange(m_path, QString());
    if (!m_next.isEmpty())
        start(std::exchange(m_next, QString()));
    else if (m_cancelled)
        emit cancelled();
    else
        emit finished(path, reading);
}

} // namespace pixelplumb
