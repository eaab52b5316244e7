// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace pixelplumb {

/// {function(0), function(1), function(2)}: for three edges, vertices or channels. Written out
/// because compilers keep in memory what a loop indexes, and these are a kernel's innermost
/// numbers; force-inlined for the same reason.
template <class Function>
[[gnu::always_inline]] constexpr auto threeOf(const Function &function)
{
    using Value = decltype(function(std::size_t(0)));
    return std::array<Value, 3>{function(std::size_t(0)), function(std::size_t(1)),
                                function(std::size_t(2))};
}

} // namespace pixelplumb
