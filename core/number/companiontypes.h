// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"

#include <concepts>
#include <cstdint>

namespace pixelplumb {

/// The types that a kernel computes with alongside Number. If Number counts its operations
/// (core/lab/counting/countednumber.h), these count theirs as well.
template <class Number>
struct CompanionTypes {
    using Narrow = std::int64_t;
    using Wide = Int128;
    using Real = double;
};
template <class Number>
using NarrowBeside = typename CompanionTypes<Number>::Narrow;
template <class Number>
using WideBeside = typename CompanionTypes<Number>::Wide;
template <class Number>
using RealBeside = typename CompanionTypes<Number>::Real;

/// True for float, double and the types that count their operations.
template <class Number>
inline constexpr bool isFloatingNumber = std::floating_point<Number>;
template <class Number>
concept FloatingNumber = isFloatingNumber<Number>;

} // namespace pixelplumb
