// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

#include <QString>

namespace pixelplumb {

struct Scene;
struct TracedScene;

enum class FrameContent { Empty, Drawn };

/// What the next click on the canvas does: shown while a primitive is incomplete, and in an empty
/// frame.
QString placingHint(PrimitiveKind kind, std::size_t pendingVertices, FrameContent content);

/// Shown where the scene's method draws none of its primitives: what the method draws, and which
/// method draws these; or that all are hidden. Empty where it draws one, and for an empty scene.
QString foreignSceneHint(const Scene &scene);

/// Why a run has no steps to show, and what to do about it; without a run, that it is being traced.
QString emptyRunText(const TracedScene *traced);

} // namespace pixelplumb
