// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

// The method table's rows for the other edge walks, related to the column scan.
Method rowWalkMethod();
Method biasColumnScanMethod();
Method constantRateColumnScanMethod();

} // namespace pixelplumb
