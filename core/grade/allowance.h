// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/counterexample.h"

namespace pixelplumb {

/// What the source draws, but the truth's pixel wherever a right program that computes in this
/// arithmetic may have the source's (undecidablePixels): what rounding alone has done is undone.
PictureSource allowingFor(Arithmetic arithmetic, const PictureSource &source);

} // namespace pixelplumb
