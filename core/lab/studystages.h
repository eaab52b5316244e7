// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"
#include "core/measure/timeleft.h"

namespace pixelplumb {

/// What runStudy() takes about on two idle cores, stage by stage, for who waits: rates that were
/// measured once, times how much is asked.
std::vector<JobStage> stagesOf(const StudySettings &settings);

/// The same of runSizeStudy().
JobStage sizeStudyStage(std::size_t contenders, int rounds);

} // namespace pixelplumb
