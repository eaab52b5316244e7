// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// A closed path of Bézier pieces, filled by parity or winding number along its chords.
Method bezierFillMethod();

} // namespace pixelplumb
