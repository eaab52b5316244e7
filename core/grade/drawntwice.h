// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picture.h"

namespace pixelplumb {

/// How many pixels a picture has as if they were painted once more than the scene's fill rule says:
/// drawn twice, as edges are that two triangles share and both own. Blending alone lets a picture
/// tell; 0 without it, and under the closed rule, which draws them twice itself.
std::int64_t drawnTwice(const Scene &scene, const Picture &found);

} // namespace pixelplumb
