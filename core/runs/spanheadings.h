// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// What the numbers of a run's spans are called where they head columns: true of all rows, under
/// the rule in force.
std::vector<NumberDescription> spanHeadings(const TracedScene &traced);

/// What the part of its primitive is called to which a span belongs: as the numbers of the span
/// count it, "triangle 1", "edge 7", from 0; where none does, "part 2".
QString partName(const ScanTrace &trace, std::size_t span);

/// What a span is called: "Column 27, second half", "Row 3".
QString spanHeading(const ScanTrace &trace, std::size_t span);

/// That of all spans of a run; Free where they differ, as those of steep and of flat edges do, and
/// where there are none.
SpanAxis commonAxis(const ScanTrace &trace);

} // namespace pixelplumb
