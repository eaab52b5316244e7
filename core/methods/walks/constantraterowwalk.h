// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// The row of the table of methods for the row walk whose colours advance by the plane's rate along
/// x, the same in every row.
Method constantRateRowWalkMethod();

} // namespace pixelplumb
