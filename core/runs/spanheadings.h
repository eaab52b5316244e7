// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The column headings for the numbers of a run's spans: true of all rows, under the current rule.
std::vector<NumberDescription> spanHeadings(const TracedScene &traced);

/// The name of the part of its primitive that a span belongs to: as the span's numbers count it,
/// "triangle 1", "edge 7", from 0; if they do not, "part 2".
QString partName(const ScanTrace &trace, std::size_t span);

/// The name of a span: "Column 27, second half", "Row 3".
QString spanHeading(const ScanTrace &trace, std::size_t span);

/// The axis of all spans of a run; Free if they differ, as those of steep and flat edges do, or if
/// there are none.
SpanAxis commonAxis(const ScanTrace &trace);

} // namespace pixelplumb
