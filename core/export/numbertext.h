// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"

#include <QString>

namespace pixelplumb {

// How numbers are written in files, for programs to read; C locale, no spaces.

/// The shortest decimal that reads back as the same double; "nan", "inf" or "-inf" where there is
/// none.
QString realText(double value);

/// A quantity as one decimal. Floating point: the shortest that reads back as the same value in
/// float64, which programs use (a float32 then shows more digits than it needs as a float32:
/// 0.10000000149011612). Rationals whose denominator is a power of two up to 2^32 (the lattice and
/// fixed point): every digit; other rationals: the nearest double. None: "".
QString decimalText(const Quantity &quantity);

/// A rational as an improper fraction in lowest terms, "277/54", whole numbers as "17"; floating
/// point as its decimal, none as "".
QString fractionText(const Quantity &quantity);

} // namespace pixelplumb
