// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

namespace pixelplumb {

/// Numbers with exact products of 128 bits.
template <class Numbers>
inline constexpr bool isWide = false;
template <template <class> class Numbers>
inline constexpr bool isWide<Numbers<Int128>> = true;

/// A kernel with nothing listening is compiled into one function, whatever else is compiled beside
/// it: a call would keep its innermost numbers in memory. Not with wide numbers, of which g++ would
/// make functions that it takes minutes for, nor with a sanitizer, which is not measured.
#ifdef PIXELPLUMB_SANITIZED_BUILD
#define PIXELPLUMB_WHOLE gnu::noinline
#else
#define PIXELPLUMB_WHOLE gnu::flatten, gnu::noinline
#endif
template <class Scan>
[[PIXELPLUMB_WHOLE]] void inOneFunction(const Scan &scan)
{
    scan();
}
#undef PIXELPLUMB_WHOLE

} // namespace pixelplumb
