// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <QString>

namespace pixelplumb {

struct Scene;
struct TracedScene;

enum class FrameContent { Empty, Drawn };

/// What the next click on the canvas does: said while a primitive is under way, and in an empty
/// frame.
QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content);

/// Where the scene's method draws none of its primitives: what the method does draw, and which
/// method draws what is there; or that all of it is hidden. Empty where it draws one, and of an
/// empty scene.
QString foreignSceneHint(const Scene &scene);

/// Why a run has no steps to show, and what to do about it; without a run, that it is on its
/// way.
QString emptyRunText(const TracedScene *traced);

} // namespace pixelplumb
