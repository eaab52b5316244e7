// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

namespace pixelplumb {

/// The positions of z, w, u, v and N among the numbers of a run's samples, as far as it computes
/// them for a primitive. A primitive carries only what it is given, whatever others in the scene
/// carry.
std::vector<std::size_t> carriedNumbers(const TracedScene &traced, std::size_t primitive);

} // namespace pixelplumb
