// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"

#include <QString>

namespace pixelplumb {

// How numbers are spelled in files, for programs to read; C locale, no spaces.

/// The shortest decimal that reads back as the same double; "nan", "inf" and "-inf" for what has
/// none.
QString realText(double value);

/// A quantity as one decimal: floating point as the shortest that reads back as the very value in
/// float64, in which programs read (a float32 has more digits in it than it would need among its
/// own: 0.10000000149011612), rationals whose denominator is a power of two (up to 2^32: the
/// lattice and fixed point) with every digit, other rationals as the nearest double. None as "".
QString decimalText(const Quantity &quantity);

/// A rational as an improper fraction in lowest terms, "277/54", whole numbers as "17"; floating
/// point as its decimal, none as "".
QString fractionText(const Quantity &quantity);

} // namespace pixelplumb
