// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/rounding/margin.h"
#include "core/grade/try/writtentrace.h"
#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The first sample on an edge that the program draws more often, or less often, than a right one
/// may by the margin: "pixel (7, 7) lies on an edge that triangles share: drawn twice, should be
/// drawn once". None where there is none.
std::optional<QString> notDrawnOnce(const ProgramTrace &trace, const TracedScene &run,
                                    const Margin &margin);

} // namespace pixelplumb
