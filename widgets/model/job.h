// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/failure.h"
#include "core/number/jobprogress.h"

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

class QThreadPool;

namespace pixelplumb {

/// Runs one piece of work at a time beside the GUI thread, which never waits for it. Newer work
/// cancels the older, whose outcome is dropped, and begins when that has ended: two large outcomes
/// never stand in memory together.
class Job : public QObject {
    Q_OBJECT

public:
    /// In the given pool, else in the program's.
    explicit Job(QObject *parent = nullptr, QThreadPool *pool = nullptr);
    /// Cancels, and does not wait: what the work needs must belong to it.
    ~Job() override;

    /// Work is under way or waits for its turn, and its outcome is wanted.
    bool isRunning() const;

    /// What a person reads of it while it is under way: "Opening scene.json".
    void setTitle(const QString &title) { m_title = title; }
    const QString &title() const { return m_title; }
    /// Newer work waits that long for a still newer one: work that a drag would cancel at each move
    /// only takes time from what is seen of it.
    void setRest(std::chrono::milliseconds rest) { m_restTimer.setInterval(rest); }

    /// `work(listener)` runs in another thread, tells the listener how far it is and ends when that
    /// says so; `take(outcome)` then runs in this one. An outcome that did not fit into memory, or
    /// did not come about by another error, is a default one.
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
    void started(); ///< or waits for its turn
    /// Some 20 times a second.
    void progressChanged(const pixelplumb::JobProgress &progress);
    void ended(); ///< before the outcome is taken, or cancelled

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

} // namespace pixelplumb
