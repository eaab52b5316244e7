// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace pixelplumb {

/// Under sanitizers a run takes ten times as long, so fewer methods, random scenes and moves are
/// tested.
#ifdef PIXELPLUMB_SANITIZED_BUILD
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

/// How many of `all` random cases to draw.
constexpr int fewerIfSanitized(int all) { return isSanitized ? (all + 7) / 8 : all; }

/// All cases, or one in eight under sanitizers.
template <class Case>
std::vector<Case> fewerIfSanitized(std::vector<Case> cases)
{
    std::erase_if(cases, [i = 0](const Case &) mutable { return isSanitized && i++ % 8 != 0; });
    return cases;
}

} // namespace pixelplumb
