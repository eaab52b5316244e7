// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace pixelplumb {

/// Samples the cost of a draw: ns of the calling thread's processor time. Draws once before the
/// clock runs, so that no draw pays for what another left in the caches. The clock is read before
/// and after all draws of the sample. If `draws` is 0 it becomes the number that fills
/// `nanoseconds`, at most 100 000.
double sampleDraw(const std::function<void()> &draw, int &draws, double nanoseconds);

} // namespace pixelplumb
