// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/curves/beziersubdivision.h"
#include "core/trace/numberrow.h"

/// The numbers of Bézier curves.
namespace pixelplumb {

const NumberTable<BezierSetUp> &bezierSetUpNumbers();
const NumberTable<BezierStep> &bezierNumbers();

/// numerator / 2^power; none if a fraction cannot hold it.
Quantity dyadic(BigInteger numerator, int power);

} // namespace pixelplumb
