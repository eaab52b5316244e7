// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/runs/explain/pixelhistory.h"

namespace pixelplumb {

/// The reason of one attempt (PixelAttempt::reason), whose other members are filled in.
QString reasonOf(const PixelAttempt &attempt, const TracedScene &traced);

} // namespace pixelplumb
