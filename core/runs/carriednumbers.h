// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// Where z, w, u, v and N stand among the numbers of a run's samples, as far as it computes them of
/// a primitive. What the primitive is not given, it does not carry, though others of the scene do.
std::vector<std::size_t> carriedNumbers(const TracedScene &traced, std::size_t primitive);

} // namespace pixelplumb
