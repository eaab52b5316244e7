// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

namespace pixelplumb {

/// The largest error of an edge walked by its rounded slope, px (resources/numerics.md, 2.2).
/// `additions`: those of the slope and the one of the start; `largest`: the largest magnitude of a
/// vertex in the coordinate that the edge computes; `extent`: the largest distance of two vertices
/// in it.
double errorLimit(Arithmetic arithmetic, double additions, double largest, double extent);

} // namespace pixelplumb
