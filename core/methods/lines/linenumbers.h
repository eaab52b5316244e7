// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/lines/linestate.h"
#include "core/trace/numberrow.h"

/// The numbers of the line methods.
namespace pixelplumb {

const NumberTable<SlopeInterceptSetUpState> &slopeInterceptSetUpNumbers();
const NumberTable<SlopeInterceptState> &slopeInterceptNumbers();
const NumberTable<DdaSetUpState> &ddaSetUpNumbers();
const NumberTable<DdaState> &ddaNumbers();
const NumberTable<ParametricLineSetUpState> &parametricLineSetUpNumbers();
const NumberTable<ParametricLineState> &parametricLineNumbers();
const NumberTable<DecisionSetUpState> &bresenhamSetUpNumbers();
const NumberTable<DecisionSetUpState> &symmetricSetUpNumbers();
const NumberTable<DecisionState> &decisionNumbers();

} // namespace pixelplumb
