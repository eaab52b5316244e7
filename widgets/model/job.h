// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/failure.h"
#include "core/number/jobprogress.h"

#include <QtCore>

#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

namespace pixelplumb {

/// The pool for jobs. It is not Qt's own, by whose threads QPainter fills large areas: the window
/// would wait for a job.
QThreadPool *jobPool();

/// Runs one piece of work at a time in a worker thread; the GUI thread never waits. Newer work
/// cancels the older, whose outcome is dropped, and begins when that has ended: two large outcomes
/// are never in memory together.
class Job : public QObject {
    Q_OBJECT

public:
    explicit Job(QObject *parent = nullptr, QThreadPool *pool = jobPool());
    /// Cancels without waiting: the work must own what it needs.
    ~Job() override;

    /// Whether work is running or waiting, and its outcome is wanted.
    bool isRunning() const;

    /// The text shown while the work is running: "Opening scene.json".
    void setTitle(const QString &title) { m_title = title; }
    const QString &title() const { return m_title; }
    /// How long newer work waits for still newer work: work that a drag cancels at each move only
    /// slows down what the drag shows.
    void setRest(std::chrono::milliseconds rest) { m_restTimer.setInterval(rest); }

    /// Runs `work(listener)` in another thread; it reports its progress to the listener and ends
    /// when that says so. `take(outcome)` then runs in this thread. Where memory ran out or another
    /// error occurred, the outcome is a default one.
    template <class Work, class Take>
    void start(Work work, Take take)
    {
        using Outcome = std::invoke_result_t<Work, const ProgressListener &>;
        enqueue([work = std::move(work),
                 take = std::move(take)](const ProgressListener &listener) -> Delivery {
            const auto outcome = std::make_shared<Outcome>();
            if (failureOf([&] { *outcome = work(listener); }))
                *outcome = Outcome();
            return [take, outcome] { take(std::move(*outcome)); };
        });
    }

public slots:
    void cancel();

signals:
    void started(); ///< or waiting
    /// About 20 times a second.
    void progressChanged(const pixelplumb::JobProgress &progress);
    void ended(); ///< before the outcome is taken, or when cancelled

private:
    using Delivery = std::function<void()>; ///< takes the outcome; runs in the GUI thread
    using Run = std::function<Delivery(const ProgressListener &)>;
    struct Control;

    void enqueue(Run run);
    void startNext();
    void end();
    void tellProgress();

    QThreadPool *m_pool;
    QString m_title;
    QFutureWatcher<Delivery> m_watcher;
    QTimer m_progressTimer;
    QTimer m_restTimer;
    std::shared_ptr<Control> m_control; ///< shared with the worker; null when none is under way
    Run m_next;
};

/// The pool for all jobs that time something: it runs one at a time, so that none disturbs another;
/// the others wait.
QThreadPool *measuringPool();

/// The title of a job about to be put there: "Measuring …", or that it waits.
QString measuringNote();

} // namespace pixelplumb
