// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/colour.h"
#include "core/geometry/lattice.h"

#include <cstdint>
#include <optional>

namespace pixelplumb {

/// Where pixel (0, 0) is and which way y grows. The assignment draws y upward.
enum class FrameOrigin { BottomLeft, TopLeft };

/// Where in its cell a pixel is sampled: at (x, y), or at (x + 1/2, y + 1/2) as in the
/// Triangle Rasterization slides.
enum class PixelCentre { Integer, Half };

inline constexpr std::int32_t largestFrameSide = 32768;
inline constexpr std::int64_t largestFrameArea = std::int64_t(1) << 28; // 1 GiB of pixels

/// A scene's description of its frame.
struct FrameSpec {
    std::int32_t width = 64; ///< columns, 1 … largestFrameSide
    std::int32_t height = 48; ///< rows, 1 … largestFrameSide; width * height <= largestFrameArea
    Colour background;
    FrameOrigin origin = FrameOrigin::BottomLeft;
    PixelCentre pixelCentre = PixelCentre::Integer;
    /// The pixel with the smallest coordinates in the frame, |each| <= 2^30 px.
    std::int32_t firstColumn = 0;
    std::int32_t firstRow = 0;
    /// The point used by the rule off-screen-point, in the scene's coordinates whatever the pixel
    /// centre. None: 1 px before the first pixel along both axes, off the screen in every frame.
    std::optional<LatticePoint> offScreenPoint = {};

    friend bool operator==(const FrameSpec &, const FrameSpec &) = default;
};

/// What to add to a sample coordinate to get the scene coordinate: 0, or 128 units (1/2 px) for
/// half centres.
constexpr Lattice sampleOffset(const FrameSpec &spec)
{
    return spec.pixelCentre == PixelCentre::Half ? halfPixel : 0;
}

/// The off-screen point in use, in sample coordinates.
constexpr LatticePoint offScreenSample(const FrameSpec &spec)
{
    const LatticePoint point = spec.offScreenPoint.value_or(
        latticePixel(std::int64_t(spec.firstColumn) - 1, std::int64_t(spec.firstRow) - 1));
    return {point.x - sampleOffset(spec), point.y - sampleOffset(spec)};
}

} // namespace pixelplumb
