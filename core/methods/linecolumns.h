// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

#include <vector>

/// What the cells of the line methods are, in the order in which linerecording.h fills them.
namespace pixelplumb {

std::vector<TraceColumn> slopeInterceptSetUpColumns();
std::vector<TraceColumn> slopeInterceptColumns();
std::vector<TraceColumn> ddaSetUpColumns();
std::vector<TraceColumn> ddaColumns();
std::vector<TraceColumn> bresenhamSetUpColumns();
std::vector<TraceColumn> bresenhamColumns();
std::vector<TraceColumn> symmetricSetUpColumns();
std::vector<TraceColumn> symmetricColumns();

} // namespace pixelplumb
