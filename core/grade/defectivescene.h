// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/defect.h"

#include <optional>
#include <span>

namespace pixelplumb {

/// The scene with those of the defects that are a scene's.
Scene withDefects(Scene scene, std::span<const Defect> defects);

/// The one of the defects that is a redrawing, or two of them as one; none where kernels draw all.
std::optional<Defect> redrawingAmong(std::span<const Defect> defects);

/// What a program with these defects draws, which can be together.
Picture pictureWith(const Scene &scene, std::span<const Defect> defects);

/// What programs with these defects draw that compute in arithmetic up to this one; none where
/// nobody knows what rounding does.
std::optional<PictureRange> rangeWith(const Scene &scene, std::span<const Defect> defects,
                                      Arithmetic arithmetic);

} // namespace pixelplumb
