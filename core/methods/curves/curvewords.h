// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/circlestate.h"
#include "core/scan/curves/beziersubdivision.h"
#include "core/scan/curves/circlemidpoint.h"
#include "core/scan/curves/pointaddress.h"
#include "core/trace/stepwords.h"

namespace pixelplumb {

/// What the methods of points, circles and curves say of their steps: which pixels they draw, and
/// why.
void tellCurve(StepWords &words, const PointStep &step);
void tellCurve(StepWords &words, const CircleExplicitState &step);
void tellCurve(StepWords &words, const CircleParametricState &step);
void tellCurve(StepWords &words, const MidpointStep &step);
void tellCurve(StepWords &words, const BezierStep &step);

} // namespace pixelplumb
