// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/methodrows.h"

namespace pixelplumb {

/// Adds to a kernel's method what all methods of polygons share: one rule for samples on the
/// boundary, and why.
Method polygonMethod(Method method);
/// The pseudocode of scan conversion by parity, wherever the edges come from.
Pseudocode parityPseudocode();
/// The loop over the rows that the edges cross, with the crossings x_k in each.
Pseudocode crossingLines(int depth);

} // namespace pixelplumb
