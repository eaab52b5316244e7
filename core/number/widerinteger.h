// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/number/integer.h"
#include "core/number/wideinteger.h"

namespace pixelplumb {

/// Maps an integer type to the one that holds products of two of its values.
template <class Integer>
struct WiderInteger;
template <>
struct WiderInteger<std::int64_t> {
    using Type = Int128;
};
template <>
struct WiderInteger<Int128> {
    using Type = Int256;
};
template <class Integer>
using TwiceAsWide = typename WiderInteger<Integer>::Type;

} // namespace pixelplumb
