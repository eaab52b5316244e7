// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

#include <vector>

/// What the cells of the methods of points, circles and curves are, in the order in which
/// pointrecording.h, circlerecording.h and bezierrecording.h fill them.
namespace pixelplumb {

std::vector<TraceColumn> pointSetUpColumns();
std::vector<TraceColumn> pointColumns();
/// Centre and radii.
std::vector<TraceColumn> roundSetUpColumns();
std::vector<TraceColumn> circleFillColumns();
std::vector<TraceColumn> circleExplicitColumns();
std::vector<TraceColumn> circleParametricSetUpColumns();
std::vector<TraceColumn> circleParametricColumns();
std::vector<TraceColumn> circleMidpointColumns();
std::vector<TraceColumn> bezierSetUpColumns();
std::vector<TraceColumn> bezierColumns();

} // namespace pixelplumb
