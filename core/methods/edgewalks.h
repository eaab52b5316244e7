// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

// The rows of the table of methods that walk along edges: the column scan's kin.
Method rowWalkMethod();
Method biasColumnScanMethod();
Method constantRateColumnScanMethod();

} // namespace pixelplumb
