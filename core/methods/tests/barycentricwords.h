// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tests/edgeteststeps.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// Says which vertices a barycentric form's letters stand for, and which weight is whose.
void tellBarycentric(StepWords &words, const EdgeTestSetUpState &state, const EdgeTestForm &form);
/// Says which weights cover a sample; a refused sample's decision says why it is refused.
void tellBarycentric(StepWords &words, const EdgeTestSampleState &state, const EdgeTestForm &form);

} // namespace pixelplumb
