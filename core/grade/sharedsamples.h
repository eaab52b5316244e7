// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

namespace pixelplumb {

/// A 1 for each pixel whose sample lies on an edge that two of the scene's triangles share, one on
/// each side, and on no other edge; line by line, the top line first. Whoever owns such a sample,
/// it is drawn.
std::vector<std::uint8_t> sharedSamples(const Scene &scene);

} // namespace pixelplumb
