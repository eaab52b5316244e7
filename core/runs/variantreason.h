// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/pixelhistory.h"

namespace pixelplumb {

/// To what a run that departs from the right algorithm may owe a wrong pixel; empty of others.
QString variantText(const PixelAttempt &attempt, const TracedScene &traced, std::int64_t x,
                    std::int64_t y);

} // namespace pixelplumb
