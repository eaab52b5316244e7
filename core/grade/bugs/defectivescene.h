// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/bugs/defect.h"
#include "core/grade/rounding/margin.h"

#include <optional>
#include <span>

namespace pixelplumb {

/// The scene changed by those of the defects that change scenes.
Scene withDefects(Scene scene, std::span<const Defect> defects);

/// Like withDefects(), with the bugs of a walk between two edges or of edge tests among them: its
/// run makes their mistakes, step by step. Other redrawings leave it unchanged.
Scene steppedWithDefects(const Scene &scene, std::span<const Defect> defects);

/// The defect that is a redrawing, or two of them combined; none where kernels draw all.
std::optional<Defect> redrawingAmong(std::span<const Defect> defects);

/// What a program with these defects draws; they must be combinable.
Picture pictureWith(const Scene &scene, std::span<const Defect> defects);

/// What programs with these defects draw by the margin: in arithmetic up to its tolerance, and on
/// edges as its leeway allows. None where the effect of rounding is unknown.
std::optional<PictureRange> rangeWith(const Scene &scene, std::span<const Defect> defects,
                                      const Margin &margin);

} // namespace pixelplumb
