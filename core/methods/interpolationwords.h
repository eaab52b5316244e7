// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/interpolationsteps.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// Where P₀, P₁ and P₂ are: sorted in a bilinear form, else as they are given.
QString verticesText(InterpolationForm form, const std::array<int, 3> &order,
                     const std::array<LatticePoint, 3> &positions);
/// Which vertices the numbers of a set-up belong to.
/// Of a triangle without area, what the closed rule paints.
QString segmentText(InterpolationForm form, const std::array<int, 3> &order);

void tellInterpolation(StepWords &words, const InterpolationSetUpState &state,
                       InterpolationForm form);
/// Which rows a column covers, and where it has no change to share out.
void tellInterpolation(StepWords &words, const InterpolationSpanState &state,
                       InterpolationForm form);

} // namespace pixelplumb
