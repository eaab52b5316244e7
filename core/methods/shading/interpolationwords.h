// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/shading/shadedstate.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// Where P₀, P₁ and P₂ are: sorted in a bilinear form, else as they are given.
QString verticesText(InterpolationForm form, const std::array<int, 3> &order,
                     const std::array<LatticePoint, 3> &positions);
/// What the closed rule paints of a triangle without area.
QString segmentText(InterpolationForm form, const std::array<int, 3> &order);

/// Says where a span of an interpolation by itself has no change to spread.
void tellInterpolated(StepWords &words, const ShadedSpanState &state, InterpolationForm form);

} // namespace pixelplumb
