// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/progress.h"

namespace pixelplumb::cli {

/// "judging: 40 %, about 6 s left"; both halves of a study take about as long.
class StudyProgress {
public:
    StudyProgress() { m_clock.start(); }

    void show(const JobProgress &told);

private:
    Progress m_progress;
    QElapsedTimer m_clock;
};

} // namespace pixelplumb::cli
