// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"

#include <vector>

namespace pixelplumb {

/// A data cache keeps whole lines. The address alone says which set a line belongs to, and a set
/// holds as many lines as it has ways.
struct DataCache {
    int lineBytes = 64;
    int sets = 64;
    int ways = 8;

    int bytes() const { return lineBytes * sets * ways; }

    friend bool operator==(const DataCache &, const DataCache &) = default;
};

/// The machine's first level, or the most common one (32 KiB) where the system does not tell.
DataCache firstLevelDataCache();

/// Where the pixels of a frame are: each 4 bytes behind its left neighbour.
struct PixelPlaces {
    std::uint64_t firstAddress = 0; ///< of the window's first pixel
    std::int64_t bytesPerRow = 0; ///< from a row to the next higher y

    explicit PixelPlaces(const FrameView &frame)
        : PixelPlaces(reinterpret_cast<std::uintptr_t>(frame.base),
                      std::int64_t(frame.stride) * std::int64_t(sizeof(QRgb)))
    {
    }
    PixelPlaces(std::uint64_t address, std::int64_t rowBytes)
        : firstAddress(address)
        , bytesPerRow(rowBytes)
    {
    }

    /// Column and row count from the window's first pixel.
    std::uint64_t address(std::int64_t column, std::int64_t row) const
    {
        return firstAddress + std::uint64_t(row * bytesPerRow)
            + std::uint64_t(column) * sizeof(QRgb);
    }
};

/// A rectangle of pixels, counted from the window's first one.
struct PixelBlock {
    std::int64_t firstColumn = 0;
    std::int64_t firstRow = 0;
    std::int64_t columns = 0;
    std::int64_t rows = 0;
};

enum class WalkOrder {
    UpColumns, ///< one column after the other, as the assignment scans
    AlongRows, ///< the columns of a strip together, row by row
};

/// What a walk over a block of pixels asks of a cache that is empty at first and replaces the line
/// of a set that was used longest ago.
struct CacheWalk {
    std::int64_t lines = 0; ///< different ones
    std::int64_t changes = 0; ///< how often a pixel lies on another line than the one before
    std::int64_t misses = 0; ///< how often a line has to come from the next level
    std::vector<int> linesOfSet; ///< how many of the lines belong to each set

    int usedSets() const;
};

CacheWalk walk(const PixelPlaces &places, const PixelBlock &block, WalkOrder order,
               const DataCache &cache);

} // namespace pixelplumb
