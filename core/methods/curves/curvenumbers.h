// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/curves/circlestate.h"
#include "core/scan/curves/circlemidpoint.h"
#include "core/scan/curves/pointaddress.h"
#include "core/trace/numberrow.h"

/// The numbers of the methods of points and circles.
namespace pixelplumb {

const NumberTable<PointSetUp> &pointSetUpNumbers();
const NumberTable<PointStep> &pointNumbers();
/// Centre and radii.
const NumberTable<Round> &roundSetUpNumbers();
const NumberTable<CircleFillState> &circleFillNumbers();
const NumberTable<CircleExplicitState> &circleExplicitNumbers();
const NumberTable<CircleParametricSetUpState> &circleParametricSetUpNumbers();
const NumberTable<CircleParametricState> &circleParametricNumbers();
/// Centre and radii, in whole pixels.
const NumberTable<MidpointSetUp> &midpointSetUpNumbers();
const NumberTable<MidpointStep> &circleMidpointNumbers();

} // namespace pixelplumb
