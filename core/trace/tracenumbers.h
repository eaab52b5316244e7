// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trace/numberdescription.h"

#include <vector>

namespace pixelplumb {

/// Descriptions of the cells in a trace's records. A run has the numbers that its plan calls for.
struct TraceNumbers {
    std::vector<NumberDescription> setUp; ///< describes SetUpRecord::cells
    std::vector<NumberDescription> span; ///< describes SpanRecord::cells, the table's columns
    std::vector<NumberDescription> sample; ///< describes SampleRecord::cells
};

} // namespace pixelplumb
