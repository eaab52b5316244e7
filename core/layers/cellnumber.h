// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "core/number/quantity.h"

namespace pixelplumb {

/// The smallest cell that gets numbers, logical px.
inline constexpr double leastNumberCell = 24;

/// A number as short as a cell needs it: one decimal from 10 on, two from 0.1 on, three from 0.001
/// on, else one digit; whole numbers as they are; a true minus sign.
QString cellNumber(const Quantity &number);

/// Like cellNumber(), but with three significant digits below 1.
QString preciseNumber(const Quantity &number);

/// Negative numbers have an ink of their own besides their sign.
LayerInk inkOf(const Quantity &number);

/// The note for cells that are too small.
QString smallCellNote();

} // namespace pixelplumb
