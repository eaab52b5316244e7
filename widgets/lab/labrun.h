// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measure/timeleft.h"
#include "widgets/lab/labresults.h"
#include "widgets/model/job.h"

#include <memory>

namespace pixelplumb {

/// Runs a study in a worker thread and shows its results so far. A cancelled run keeps what it has.
/// Waits while something else is being timed.
class LabRun : public QObject {
    Q_OBJECT

public:
    explicit LabRun(QObject *parent = nullptr);
    ~LabRun() override;

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

} // namespace pixelplumb
