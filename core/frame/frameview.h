// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"

#include <QRgb>

#include <cstddef>

namespace pixelplumb {

/// The pixels that a kernel may write: a window [firstColumn, endColumn) x [firstRow, endRow) of
/// the sample lattice. As in the Rasterization slides, "Point Plotting" (addr = y * width + x), but
/// with a stride of its own that is negative where row 0 is the lowest line of the picture.
struct FrameView {
    QRgb *base = nullptr; ///< the pixel (firstColumn, firstRow)
    std::ptrdiff_t stride = 0; ///< pixels from a row to the next higher y
    std::int32_t firstColumn = 0;
    std::int32_t firstRow = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
    // Used by fill rules.
    FrameOrigin origin = FrameOrigin::BottomLeft; ///< which way y points on screen
    PixelCentre pixelCentre = PixelCentre::Integer; ///< where a text's rounded box has its samples
    LatticePoint offScreenPoint = latticePixel(-1, -1); ///< sample coordinates

    constexpr std::int64_t endColumn() const { return std::int64_t(firstColumn) + width; }
    constexpr std::int64_t endRow() const { return std::int64_t(firstRow) + height; }
    constexpr bool contains(std::int64_t x, std::int64_t y) const
    {
        return x >= firstColumn && x < endColumn() && y >= firstRow && y < endRow();
    }
    /// The address of a pixel inside the window.
    QRgb *at(std::int64_t x, std::int64_t y) const
    {
        return base + (y - firstRow) * stride + (x - firstColumn);
    }
};

/// The frame's window without memory: for code that needs pixel positions and writes no pixels.
constexpr FrameView windowOf(const FrameSpec &spec)
{
    FrameView window;
    window.firstColumn = spec.firstColumn;
    window.firstRow = spec.firstRow;
    window.width = spec.width;
    window.height = spec.height;
    window.origin = spec.origin;
    window.pixelCentre = spec.pixelCentre;
    window.offScreenPoint = offScreenSample(spec);
    return window;
}

} // namespace pixelplumb
