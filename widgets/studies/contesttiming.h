// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compare/contest.h"
#include "core/lab/scenecost.h"
#include "widgets/model/job.h"

namespace pixelplumb {

/// Measures what each contender of a contest costs, in a worker thread, after their pictures are
/// drawn. The truth is not timed.
class ContestTiming : public QObject {
    Q_OBJECT

public:
    explicit ContestTiming(QObject *parent = nullptr);

    void measure(const std::shared_ptr<const Contest> &contest);
    void cancel() { m_job.cancel(); }

signals:
    void measured(std::size_t run, const pixelplumb::SceneCost &cost);

private:
    Job m_job;
};

} // namespace pixelplumb
