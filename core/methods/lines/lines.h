// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// y = m·x + b for each column, taken literally.
Method lineSlopeInterceptMethod();
/// P(t) = P₀ + t·(P₁ − P₀).
Method lineParametricMethod();
/// The digital differential analyzer.
Method lineDdaMethod();
/// Bresenham's line in all octants.
Method lineBresenhamMethod();
/// Bresenham's line with a tie rule that ignores directions.
Method lineSymmetricMethod();

} // namespace pixelplumb
