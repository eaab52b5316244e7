// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"
#include "core/scan/edgetestform.h"

#include <vector>

namespace pixelplumb {

/// What the cells of EdgeTestRecording are, in their order, by the names of the form's slides.
std::vector<TraceColumn> edgeTestSetUpColumns(const EdgeTestForm &form);
std::vector<TraceColumn> edgeTestSpanColumns(const EdgeTestForm &form);
std::vector<TraceColumn> edgeTestSampleColumns(const EdgeTestForm &form);

} // namespace pixelplumb
