// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"

#include <cstdint>

namespace pixelplumb {

/// Where pixel (0, 0) is and which way y grows. The assignment (seed 004) draws y upward.
enum class FrameOrigin { BottomLeft, TopLeft };

/// Where in its cell a pixel is sampled: at (x, y), or at (x + 1/2, y + 1/2) as in seed 000.
enum class PixelCentre { Integer, Half };

inline constexpr std::int32_t largestFrameSide = 32768;
inline constexpr std::int64_t largestFrameArea = std::int64_t(1) << 28; // 1 GiB of pixels

/// What a scene says of its frame.
struct FrameSpec {
    std::int32_t width = 64; ///< columns, 1 … largestFrameSide
    std::int32_t height = 48; ///< rows, 1 … largestFrameSide; width * height <= largestFrameArea
    Colour background;
    FrameOrigin origin = FrameOrigin::BottomLeft;
    PixelCentre pixelCentre = PixelCentre::Integer;
    /// The pixel with the smallest coordinates that the frame shows, |each| <= 2^30 px.
    std::int32_t firstColumn = 0;
    std::int32_t firstRow = 0;

    friend bool operator==(const FrameSpec &, const FrameSpec &) = default;
};

} // namespace pixelplumb
