// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QtConcurrent>

#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <utility>

namespace pixelplumb {

/// What a job beside the GUI thread is told and tells while it works.
struct JobControl {
    std::atomic<bool> cancelled = false;
    std::atomic<int> done = 0;
    std::atomic<int> total = 0; ///< 0: it cannot say
};

/// Runs one job at a time beside the GUI thread. A newer one cancels the one under way, whose
/// outcome is dropped; so is that of a cancelled one. An outcome that did not fit into memory is a
/// default one.
template <class Outcome>
class LatestJob {
public:
    using Work = std::function<Outcome(JobControl &control)>;
    using Take = std::function<void(Outcome outcome)>;

    LatestJob()
    {
        QObject::connect(&m_watcher, &QFutureWatcherBase::finished, &m_watcher,
                         [this] { finish(); });
    }
    ~LatestJob()
    {
        if (!m_control)
            return;
        m_watcher.disconnect();
        m_control->cancelled = true;
        m_watcher.waitForFinished();
    }
    Q_DISABLE_COPY_MOVE(LatestJob)

    bool isRunning() const { return m_control != nullptr; }
    /// Null when nothing is under way.
    const JobControl *control() const { return m_control.get(); }

    void start(Work work, Take take)
    {
        if (m_control) {
            m_control->cancelled = true;
            m_next = {std::move(work), std::move(take)};
            return;
        }
        m_control = std::make_unique<JobControl>();
        m_take = std::move(take);
        m_watcher.setFuture(
            QtConcurrent::run([work = std::move(work), control = m_control.get()]() -> Outcome {
                try {
                    return work(*control);
                } catch (const std::bad_alloc &) {
                    return {};
                }
            }));
    }
    void cancel()
    {
        m_next = {};
        if (m_control)
            m_control->cancelled = true;
    }

private:
    void finish()
    {
        Outcome outcome = m_watcher.future().takeResult();
        const bool wasCancelled = m_control->cancelled;
        m_control.reset();
        const Take take = std::exchange(m_take, {});
        if (m_next.first) {
            auto [work, next] = std::exchange(m_next, {});
            start(std::move(work), std::move(next));
            return;
        }
        if (!wasCancelled)
            take(std::move(outcome));
    }

    QFutureWatcher<Outcome> m_watcher;
    std::unique_ptr<JobControl> m_control; ///< shared with the worker
    Take m_take;
    std::pair<Work, Take> m_next; ///< waits for the cancelled one to end
};

} // namespace pixelplumb
