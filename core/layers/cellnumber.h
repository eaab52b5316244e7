// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layerdrawing.h"
#include "core/number/quantity.h"

namespace pixelplumb {

/// The smallest cell in which numbers are put, logical px.
inline constexpr double leastNumberCell = 24;

/// A number as short as a cell asks for: one decimal from 10 on, two from 0.1 on, three from 0.001
/// on, else one digit; whole numbers as they are; a true minus sign.
QString cellNumber(const Quantity &number);

/// The same with three digits that count where it is below 1.
QString preciseNumber(const Quantity &number);

/// Negative numbers have an ink of their own beside their sign.
LayerInk inkOf(const Quantity &number);

/// To be said where cells are too small.
QString smallCellNote();

} // namespace pixelplumb
