// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgeteststeps.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// Which vertices the letters of a barycentric form stand for, and whose weight is which.
void tellBarycentric(StepWords &words, const EdgeTestSetUpState &state, const EdgeTestForm &form);
/// Of a covered sample, by which weights it is; why another is refused is told by its decision.
void tellBarycentric(StepWords &words, const EdgeTestSampleState &state, const EdgeTestForm &form);

} // namespace pixelplumb
