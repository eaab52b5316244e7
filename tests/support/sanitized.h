// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace pixelplumb {

/// Under sanitizers a run takes ten times as long: fewer methods, random scenes and moves are
/// taken.
#ifdef PIXELPLUMB_SANITIZED_BUILD
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

/// How many of so many random cases are drawn.
constexpr int fewerIfSanitized(int all) { return isSanitized ? (all + 7) / 8 : all; }

} // namespace pixelplumb
