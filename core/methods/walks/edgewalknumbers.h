// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/edgewalkstate.h"
#include "core/methods/words/edgewalkform.h"
#include "core/trace/numberrow.h"

namespace pixelplumb {

/// The numbers of an edge walk.
NumberTable<EdgeWalkSetUpState> edgeWalkSetUpNumbers(const EdgeWalkForm &form);
NumberTable<EdgeWalkSpanState> edgeWalkSpanNumbers(const EdgeWalkForm &form);
NumberTable<EdgeWalkSampleState> edgeWalkSampleNumbers(const EdgeWalkForm &form);

} // namespace pixelplumb
