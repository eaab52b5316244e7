// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <concepts>
#include <cstdint>

namespace pixelplumb {

/// What a kernel computes with beside its numbers. Beside a number that counts its operations
/// (core/lab/countednumber.h) these count as well.
template <class Number>
struct NumbersBeside {
    using Narrow = std::int64_t;
    using Wide = Int128;
    using Real = double;
};
template <class Number>
using NarrowBeside = typename NumbersBeside<Number>::Narrow;
template <class Number>
using WideBeside = typename NumbersBeside<Number>::Wide;
template <class Number>
using RealBeside = typename NumbersBeside<Number>::Real;

/// float and double, and what counts their operations.
template <class Number>
inline constexpr bool isFloatingNumber = std::floating_point<Number>;
template <class Number>
concept FloatingNumber = isFloatingNumber<Number>;

} // namespace pixelplumb
