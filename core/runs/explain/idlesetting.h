// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

namespace pixelplumb {

/// What a user chooses about drawing a scene, besides the method.
enum class DrawingSetting { Arithmetic, FillRule, Rounding };

/// Why no other choice of a setting would change the scene's picture, to be read after the method's
/// name: "keeps the fill rule “closed” alone: …". Empty if one may, and if the scene's method does
/// not exist.
QString idleReason(DrawingSetting setting, const Scene &scene);

} // namespace pixelplumb
