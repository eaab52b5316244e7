// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// The row of the table of methods for the assignment's column scan.
Method columnScanMethod();

} // namespace pixelplumb
