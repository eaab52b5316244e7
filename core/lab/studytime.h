// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lab/study.h"

namespace pixelplumb {

/// What runStudy() takes about on two idle cores, in s, for who waits: rates that were measured
/// once, times how much is asked.
double expectedSecondsOf(const StudySettings &settings);

} // namespace pixelplumb
