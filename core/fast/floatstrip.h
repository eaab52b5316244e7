// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"

#include <array>
#include <limits>

namespace pixelplumb {

/// Sixteen neighbouring columns of the assignment's scan in float32, ready to be coloured: one lane
/// per column, with the numbers that the plain kernel computed for it.
struct FloatStrip {
    static constexpr std::int32_t columns = 16;
    static constexpr std::int32_t never = std::numeric_limits<std::int32_t>::max();

    std::int32_t firstColumn = 0; ///< counted from the window's first
    alignas(64) std::array<std::int32_t, columns> firstRow = {}; ///< `never` in an empty lane
    alignas(64) std::array<std::int32_t, columns> endRow = {};
    alignas(64) std::array<std::array<float, columns>, 3> colour = {}; ///< at firstRow
    alignas(64) std::array<std::array<float, columns>, 3> rate = {}; ///< ΔR ΔG ΔB
};

} // namespace pixelplumb
