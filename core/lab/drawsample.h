// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace pixelplumb {

/// A sample of what a draw takes: ns of the calling thread's processor time. Draws once before the
/// clock runs: what another one left in the caches is nobody's cost. The clock is read before and
/// after all draws of the sample, of which `draws` become as many as fill so many nanoseconds, at
/// most 100 000, where it is 0.
double sampleDraw(const std::function<void()> &draw, int &draws, double nanoseconds);

} // namespace pixelplumb
