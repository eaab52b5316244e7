// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// The pixels that a kernel may write: a window [firstColumn, endColumn) x [firstRow, endRow) of
/// the sample lattice. As in the seed (002, "Point Plotting", addr = y * width + x), but with a
/// stride of its own that is negative where row 0 is the lowest line of the picture.
struct FrameView {
    QRgb *base = nullptr; ///< the pixel (firstColumn, firstRow)
    std::ptrdiff_t stride = 0; ///< pixels from a row to the next higher y
    std::int32_t firstColumn = 0;
    std::int32_t firstRow = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;

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

} // namespace pixelplumb
