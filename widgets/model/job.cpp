// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/job.h"

#include <QtConcurrent>
#include <QtWidgets>

#include <atomic>
#include <mutex>
#include <optional>

namespace pixelplumb {

using namespace std::chrono_literals;

/// The state of one run; it may outlive the job.
struct Job::Control {
    std::atomic<bool> isCancelled = false;
    std::mutex mutex; ///< of the progress
    std::optional<JobProgress> progress; ///< none before the first report

    bool hear(const JobProgress &told)
    {
        const std::lock_guard lock(mutex);
        progress = told;
        return !isCancelled;
    }
    std::optional<JobProgress> told()
    {
        const std::lock_guard lock(mutex);
        return progress;
    }
};

namespace {

/// A pool that ends with the application.
QThreadPool *poolOf(QPointer<QThreadPool> &pool, int threads)
{
    if (!pool) {
        pool = new QThreadPool(QCoreApplication::instance());
        pool->setMaxThreadCount(threads);
    }
    return pool;
}

} // namespace

QThreadPool *jobPool()
{
    static QPointer<QThreadPool> pool;
    return poolOf(pool, QThread::idealThreadCount());
}

Job::Job(QObject *parent, QThreadPool *pool)
    : QObject(parent)
    , m_pool(pool)
{
    m_progressTimer.setInterval(50ms);
    m_restTimer.setInterval(0ms);
    m_restTimer.setSingleShot(true);
    connect(&m_progressTimer, &QTimer::timeout, this, &Job::tellProgress);
    connect(&m_restTimer, &QTimer::timeout, this, &Job::startNext);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &Job::end);
}

Job::~Job()
{
    if (m_control)
        m_control->isCancelled = true;
}

bool Job::isRunning() const { return m_next || (m_control && !m_control->isCancelled); }

void Job::cancel()
{
    if (!isRunning())
        return;
    m_next = {};
    if (m_control)
        m_control->isCancelled = true;
    m_progressTimer.stop();
    emit ended();
}

void Job::enqueue(Run run)
{
    const bool isFirst = !m_control && !m_next;
    if (m_control)
        m_control->isCancelled = true;
    m_next = std::move(run);
    if (isFirst)
        startNext();
    else
        m_restTimer.start();
    emit started();
}

/// Called when the cancelled run or the rest ends; the later call starts the next run.
void Job::startNext()
{
    if (!m_next || m_control || m_restTimer.isActive())
        return;
    m_control = std::make_shared<Control>();
    const auto run = [run = std::exchange(m_next, {}), control = m_control] {
        return run([&control](const JobProgress &progress) { return control->hear(progress); });
    };
    m_watcher.setFuture(QtConcurrent::run(m_pool, run));
    m_progressTimer.start();
}

void Job::end()
{
    m_progressTimer.stop();
    // Moved out, so that the watcher does not keep a large outcome alive beside the shown one.
    const Delivery deliver = m_watcher.future().takeResult();
    if (std::exchange(m_control, nullptr)->isCancelled) {
        startNext();
        return;
    }
    emit ended();
    deliver();
}

void Job::tellProgress()
{
    if (const std::optional<JobProgress> progress = m_control->told())
        emit progressChanged(*progress);
}

QThreadPool *measuringPool()
{
    static QPointer<QThreadPool> pool;
    return poolOf(pool, 1);
}

QString measuringNote()
{
    return measuringPool()->activeThreadCount() > 0
        ? QCoreApplication::translate("pixelplumb::Measuring", "Waiting for another measurement …")
        : QCoreApplication::translate("pixelplumb::Measuring", "Measuring …");
}

} // namespace pixelplumb
