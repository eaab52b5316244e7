// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace pixelplumb {

/// Where a triangle of the frame comes from: a piece of the fan of a solid's clipped face.
struct TriangleSource {
    std::uint32_t solid = 0;
    std::uint32_t face = 0;
    std::uint32_t piece = 0;

    friend bool operator==(const TriangleSource &, const TriangleSource &) = default;
};

} // namespace pixelplumb
