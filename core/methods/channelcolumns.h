// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/tracecolumn.h"

#include <vector>

namespace pixelplumb {

/// One column for each of R, G and B; % in the pattern's texts stands for the letter.
void appendChannels(std::vector<TraceColumn> &columns, const TraceColumn &pattern);

} // namespace pixelplumb
