// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// Under sanitizers a run takes ten times as long: of the arithmetics of a method one is taken at a
/// time, in turns, and of random scenes and moves fewer.
#ifdef PIXELPLUMB_SANITIZED_BUILD
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

} // namespace pixelplumb
