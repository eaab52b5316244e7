// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/hunt/counterexample.h"

namespace pixelplumb {

/// The source with rounding undone: it draws the truth's pixel wherever a right program that
/// has this margin may have the source's (undecidablePixels). At samples on an edge
/// that both draw, only neighbouring bytes are exchanged.
PictureSource allowingFor(const Margin &margin, const PictureSource &source);

} // namespace pixelplumb
