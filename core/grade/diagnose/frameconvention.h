// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.h"

#include <array>

namespace pixelplumb {

/// Where a program takes the frame's origin and its samples to be, compared with what its scene
/// says.
enum class FrameConvention { AsAsked, OtherOrigin, OtherCentre, OtherBoth };
inline constexpr std::array allFrameConventions
    = {FrameConvention::AsAsked, FrameConvention::OtherOrigin, FrameConvention::OtherCentre,
       FrameConvention::OtherBoth};
QString nameOf(FrameConvention convention); ///< "as asked", "other origin", …

/// The scene as a program of this convention reads it.
Scene sceneIn(Scene scene, FrameConvention convention);

/// What a student is told of a convention that is not the one asked for.
QString sentenceOf(FrameConvention convention);

} // namespace pixelplumb
