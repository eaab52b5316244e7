// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scan/scansettings.h"

namespace pixelplumb {

/// What an edge walked by its rounded slope may err by, px (resources/numerics.md, 2.2).
/// `additions`: those of the slope and the one of the start; `largest`: the magnitude that no
/// vertex exceeds along the edge's values; `extent`: the largest distance of two vertices along
/// them.
double errorLimit(Arithmetic arithmetic, double additions, double largest, double extent);

} // namespace pixelplumb
