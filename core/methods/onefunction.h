// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

namespace pixelplumb {

/// Whether numbers have exact products of 128 bits.
template <class Numbers>
inline constexpr bool isWide = false;
template <template <class> class Numbers>
inline constexpr bool isWide<Numbers<Int128>> = true;

/// Compiles a kernel without observer into one function, whatever else is compiled with it: a call
/// would keep its innermost numbers in memory. Not for wide numbers, whose functions take g++
/// minutes, nor with a sanitizer, which is not measured.
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
