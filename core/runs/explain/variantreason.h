// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/pixelhistory.h"

namespace pixelplumb {

/// What may make a pixel wrong in a run that departs from the correct algorithm; else empty.
QString variantText(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                    std::int64_t y);

} // namespace pixelplumb
