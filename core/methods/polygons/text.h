// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/methods/method.h"

namespace pixelplumb {

/// A text as the outlines of its glyphs, filled as a polygon.
Method textOutlinesMethod();

} // namespace pixelplumb
