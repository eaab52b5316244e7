// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// y = ±√(r² − x²) for each column.
Method circleExplicitMethod();
/// (r·cos θ, r·sin θ) in steps of 1/r.
Method circleParametricMethod();
/// The midpoint circle and ellipse.
Method circleMidpointMethod();
/// Filled circles and ellipses by spans.
Method circleFillMethod();
/// Bézier curves by recursive subdivision.
Method bezierSubdivisionMethod();
/// Points by their address.
Method pointAddressMethod();

} // namespace pixelplumb
