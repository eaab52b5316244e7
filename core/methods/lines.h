// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// y = m·x + b for each column, to the letter.
Method lineSlopeInterceptMethod();
/// P(t) = P₀ + t·(P₁ − P₀).
Method lineParametricMethod();
/// The digital differential analyzer.
Method lineDdaMethod();
/// Bresenham's line in all octants.
Method lineBresenhamMethod();
/// Bresenham's line with a rule for ties that does not know directions.
Method lineSymmetricMethod();

} // namespace pixelplumb
