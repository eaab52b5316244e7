// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pixelplumb {

/// Which coordinate the samples of a span share.
enum class SpanAxis : std::uint8_t {
    Column, ///< x
    Row, ///< y
    Free, ///< neither: a step of a curve, a point
};

} // namespace pixelplumb
