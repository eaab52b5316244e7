// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/shape.h"

namespace pixelplumb {

/// "3 vertices have a depth outside 0 … 1, which 16 bits keep as 0 or 1": empty if the depth buffer
/// keeps every vertex's z. Comparing clamped depths is not comparing the z that the scene gives.
QString clampedDepthsText(const Primitives &primitives);

} // namespace pixelplumb
