// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/pictures/picture.h"

namespace pixelplumb {

/// How many pixels look painted once more than the scene's fill rule says, as on edges that two
/// triangles share and both own. Only blending shows this; 0 without it, and under the closed rule,
/// which draws them twice itself.
std::int64_t drawnTwice(const Scene &scene, const Picture &found);

} // namespace pixelplumb
