// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

// The rows of the table of methods for barycentric coordinates, in the slides' forms and in a
// stable one.
Method allSamplesBarycentricMethod();
Method rectangleBarycentricMethod();
Method incrementalBarycentricMethod();
Method cramerBarycentricMethod();
Method offScreenBarycentricMethod();
Method relativeBarycentricMethod();

} // namespace pixelplumb
