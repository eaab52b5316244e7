// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study/study.h"
#include "core/measure/timeleft.h"
#include "widgets/model/job.h"

#include <memory>

namespace pixelplumb {

/// What the lab shows: a study, finished or not.
using SharedResults = std::shared_ptr<const Study>;

/// Runs a study in a worker thread and shows its results so far. A cancelled run keeps what it has.
/// Waits while something else is being timed.
class LabRun : public QObject {
    Q_OBJECT

public:
    explicit LabRun(QObject *parent = nullptr);

    bool isRunning() const { return m_job.isRunning(); }
    /// The progress and the time left.
    const TimeLeft &timeLeft() const { return m_timeLeft; }

    void start(const StudySettings &settings);
    /// Ends the run after the current sample; its results so far are then reported, and ended().
    void cancel();
    /// Ends the run without signals and drops its results.
    void drop();

signals:
    void resultsChanged(const std::shared_ptr<const pixelplumb::Study> &results);
    void progressed();
    void ended(); ///< after the last resultsChanged()

private:
    class Board;

    void takeNews();

    Job m_job;
    TimeLeft m_timeLeft{0};
    std::shared_ptr<Board> m_board; ///< shared with the worker
};

/// Which results the lab shows while runs and files come and go: results stay until others can be
/// shown in their place.
class ShownResults {
public:
    const SharedResults &results() const { return m_results; } ///< null before the first ones
    /// Whether the results are from the last run, not from before it.
    bool areOfRun() const { return m_areOfRun; }

    void beginRun();
    /// Takes a run's results so far. They do not replace others, and this returns false, until they
    /// have times of the shown family.
    bool takeNews(const SharedResults &news, const QString &family);
    /// Shows the run's results if they have times. False where nothing changes.
    bool endRun();

    void replaceBy(SharedResults results) { m_results = std::move(results); }

private:
    bool showNews();

    SharedResults m_results;
    SharedResults m_news; ///< of the run, while not shown
    bool m_areOfRun = false;
};

} // namespace pixelplumb
