// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/effects/effectplan.h"
#include "core/scene/scene.h"

namespace pixelplumb {

/// What the scene's triangles, including its solids', and its shapes need, and what is run: for
/// those that its method draws.
EffectPlan planOf(const Scene &scene);

/// Why the scene's method cannot draw it, under its settings or with the effects that its plan
/// runs, to be read after the method's name; empty when it can. The method must exist.
QString objectionTo(const Scene &scene);

/// Whether the scene's method draws any of its primitives, or there are none to draw.
bool drawsAnyOf(const Scene &scene);

} // namespace pixelplumb
