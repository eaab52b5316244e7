// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"
#include "core/scan/interpolationscan.h"

#include <vector>

namespace pixelplumb {

/// The cells of the three forms of interpolation, in the order in which InterpolationRecording
/// fills them.
std::vector<TraceColumn> interpolationSetUpColumns(InterpolationForm form);
std::vector<TraceColumn> interpolationSpanColumns(InterpolationForm form);
std::vector<TraceColumn> interpolationSampleColumns(InterpolationForm form);

} // namespace pixelplumb
