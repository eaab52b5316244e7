// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// Lines, circles, ellipses and Bézier curves one pixel wide: the method that antialiases them.
Method strokeCoverageMethod();

} // namespace pixelplumb
