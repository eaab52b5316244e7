// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "core/number/quantity.h"

namespace pixelplumb {

/// The smallest cell in which numbers are put, logical px.
inline constexpr double leastNumberCell = 24;

/// A number as short as a cell asks for: two decimals below 10, one below 100, none above; whole
/// numbers as they are; a true minus sign.
QString cellNumber(const Quantity &number);

/// Negative numbers have an ink of their own beside their sign.
LayerInk inkOf(const Quantity &number);

/// To be said where cells are too small.
QString smallCellNote();

} // namespace pixelplumb
