// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The marks of a traced scene whose trace, truth and differences are complete.
std::vector<TraceMark> marksOf(const TracedScene &traced);

} // namespace pixelplumb
