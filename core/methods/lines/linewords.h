// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/lines/linestate.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// What a line method says: which end it stores first and whether x and y are exchanged; for a
/// step, which pixel it draws, and why.
void tellLine(StepWords &words, const SlopeInterceptSetUpState &state);
void tellLine(StepWords &words, const DdaSetUpState &state);
void tellLine(StepWords &words, const ParametricLineSetUpState &state);
void tellLine(StepWords &words, const DecisionSetUpState &state);
void tellLine(StepWords &words, const SlopeInterceptState &state);
void tellLine(StepWords &words, const DdaState &state);
void tellLine(StepWords &words, const ParametricLineState &state);
void tellLine(StepWords &words, const DecisionState &state);

} // namespace pixelplumb
