// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/circlestate.h"
#include "core/scan/circlefill.h"
#include "core/scan/circlemidpoint.h"
#include "core/scan/pointaddress.h"
#include "core/trace/numberrow.h"

/// The numbers of the methods of points and circles.
namespace pixelplumb {

const NumberTable<PointSetUp> &pointSetUpNumbers();
const NumberTable<PointStep> &pointNumbers();
/// Centre and radii.
const NumberTable<Round> &roundSetUpNumbers();
const NumberTable<CircleFillRow> &circleFillNumbers();
const NumberTable<CircleExplicitState> &circleExplicitNumbers();
const NumberTable<CircleParametricSetUpState> &circleParametricSetUpNumbers();
const NumberTable<CircleParametricState> &circleParametricNumbers();
/// The same as of all circles, in whole pixels.
const NumberTable<MidpointSetUp> &midpointSetUpNumbers();
const NumberTable<MidpointStep> &circleMidpointNumbers();

} // namespace pixelplumb
