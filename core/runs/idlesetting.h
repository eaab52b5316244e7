// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

namespace pixelplumb {

/// What a person chooses of how a scene is drawn, beside the method.
enum class DrawingSetting { Arithmetic, FillRule, Rounding };

/// Why no other choice of a setting would change the scene's picture, to be read after the method's
/// name: "keeps the fill rule “closed” alone: …". Empty where one may, and where the scene's method
/// does not exist.
QString idleReason(DrawingSetting setting, const Scene &scene);

} // namespace pixelplumb
