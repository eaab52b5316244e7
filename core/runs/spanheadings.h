// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// What the numbers of a run's spans are called where they head columns: true of all rows, under
/// the rule in force.
std::vector<NumberDescription> spanHeadings(const TracedScene &traced);

} // namespace pixelplumb
