// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace pixelplumb {

class SceneDocument;

/// The current frame of a moving scene, from 0; none for a still one.
std::optional<int> movingFrame(const SceneDocument &document);
/// "frame 8 of 24 of the motion"; empty where the scene stands still.
QString frameText(const SceneDocument &document);

} // namespace pixelplumb
