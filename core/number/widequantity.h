// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/quantity.h"
#include "core/number/wideinteger.h"

namespace pixelplumb {

/// numerator/denominator in lowest terms; the nearest double where that does not fit 128 bits. The
/// denominator is not 0.
Quantity quotientOf(const BigInteger &numerator, const BigInteger &denominator);

} // namespace pixelplumb
