// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/counterexample.h"

namespace pixelplumb {

/// What the source draws, but the truth's pixel wherever a right program that computes in this
/// arithmetic may have the source's (undecidablePixels): what rounding alone has done is undone. Of
/// samples on an edge that both draw, only bytes that are neighbours are exchanged.
PictureSource allowingFor(Arithmetic arithmetic, const PictureSource &source);

} // namespace pixelplumb
