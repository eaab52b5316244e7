// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"
#include "core/scene/scene.h"

#include <optional>

namespace pixelplumb {

/// A scene and its run: its solids are projected once, and its plan is computed once. The scene's
/// method must exist.
struct SceneRun : Run {
    explicit SceneRun(const Scene &of);
    /// Of a scene whose primitives are on samples already.
    SceneRun(const Scene &of, Primitives onSamples);

    Scene scene;
};

/// None where the listener, which hears how many faces of solids are projected, ended it.
std::optional<SceneRun> sceneRunOf(const Scene &scene, const ProgressListener &listener);

/// What the scene's triangles, including its solids', and its shapes need, and what is run: for
/// those that its method draws.
EffectPlan planOf(const SceneRun &run);

/// Why the scene's method cannot draw it, under its settings or with the effects that its plan
/// runs, to be read after the method's name; empty when it can. The method must exist.
QString objectionTo(const SceneRun &run);
/// Makes a run only where the scene and its settings alone do not tell.
QString objectionTo(const Scene &scene);

/// Whether the scene's method draws any of its primitives, or there are none to draw.
bool drawsAnyOf(const Scene &scene);

} // namespace pixelplumb
