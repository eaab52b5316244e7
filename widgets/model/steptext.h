// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/tracedscene.h"

#include <QtCore>

#include <optional>

namespace pixelplumb {

class SceneDocument;

/// What the step before a position did: "pixel (27, 19) written".
QString stepText(const TracedScene &traced, std::size_t position);
/// What a mark means: "tie: a sample of this column lies exactly on an edge".
QString markText(const TracedScene &traced, const TraceMark &mark);
/// "column 27, second half", or the triangle that was set up.
QString columnText(const TracedScene &traced, std::size_t position);

/// The current frame of a moving scene, from 0; none for a still one.
std::optional<int> movingFrame(const SceneDocument &document);
/// "frame 8 of 24 of the motion"; empty where the scene stands still.
QString frameText(const SceneDocument &document);

/// Reads a typed pixel: "27 19", "27, 19", "27; 19" or "(27, 19)".
std::optional<QPoint> typedPixel(const QString &text);

} // namespace pixelplumb
