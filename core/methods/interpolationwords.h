// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationsteps.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// Which vertices the numbers of a set-up belong to.
void tellInterpolation(StepWords &words, const InterpolationSetUpState &state,
                       InterpolationForm form);
/// Which rows a column covers, and where it has no change to share out.
void tellInterpolation(StepWords &words, const InterpolationSpanState &state,
                       InterpolationForm form);

} // namespace pixelplumb
