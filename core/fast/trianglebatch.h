// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pixelplumb {

/// A few neighbouring triangles of a scene as a structure of arrays: the input for setting up a
/// vector of triangles, and the results for drawing them one after another. The arrays fit the
/// first-level cache; entries beyond `size` are left over from earlier triangles and unused.
struct TriangleBatch {
    static constexpr std::size_t capacity = 32;
    template <class Value>
    using Array = std::array<Value, capacity>;
    template <class Value>
    using PerCorner = std::array<Array<Value>, 3>; ///< or per edge, per channel
    using Set = std::uint32_t; ///< of triangles: bit i stands for the one at i

    std::size_t size = 0;
    const Triangle *source = nullptr; ///< `size` consecutive triangles, often followed by the next
                                      ///< batch
    Set farAway = 0; ///< beyond ±2^15 px of the window: only the plain kernel draws them
    Set flat = 0; ///< the three vertices have one colour
    /// Neither empty nor of zero area, at most blockColumns and blockExtent in size, and with exact
    /// 24-bit colours. Most triangles of a crowded scene are, and they are recognized all at once.
    Set small = 0;
    Set narrow = 0; ///< at most 8 columns
    Set spansRows = 0; ///< if drawn by spans, by spans of rows; the others by spans of columns

    // From the scene: lattice units from the window's first sample, |each| <= 2^23; colours as
    // 0x00bbggrr.
    alignas(64) PerCorner<std::int32_t> x = {};
    alignas(64) PerCorner<std::int32_t> y = {};
    alignas(64) PerCorner<std::uint32_t> colour = {};

    // From the set-up: the samples of the bounding box inside the window, counted from its first
    // sample.
    alignas(64) Array<std::int32_t> firstColumn = {};
    alignas(64) Array<std::int32_t> endColumn = {};
    alignas(64) Array<std::int32_t> firstRow = {};
    alignas(64) Array<std::int32_t> endRow = {};
    /// The longer side of the unclipped box, lattice units.
    alignas(64) Array<std::int32_t> extent = {};

    /// Doubled area with its sign, square lattice units.
    alignas(64) Array<double> signedArea = {};
    /// Doubled area on the coarsest lattice that holds all corners: A' of colourplane.h.
    alignas(64) Array<double> reducedArea = {};
    /// 4 A' (n + 1): how many steps a colour word must distinguish (colourplane.h).
    alignas(64) Array<double> resolution = {};
    /// The largest of the colour plane's numbers, in steps of its word.
    alignas(64) Array<double> magnitude = {};
    /// The colour plane at the first sample of the box, and its change per column and row.
    alignas(64) PerCorner<std::uint64_t> start = {};
    alignas(64) PerCorner<std::uint64_t> perColumn = {};
    alignas(64) PerCorner<std::uint64_t> perRow = {};

    /// The colour plane in 8.24, meaningful for small triangles, and the edge functions at the
    /// first sample of the box, meaningful while extent is at most blockExtent: at least 0 where
    /// the fill rule has the sample inside, in any positive unit.
    alignas(64) PerCorner<std::uint32_t> narrowStart = {};
    alignas(64) PerCorner<std::uint32_t> narrowPerColumn = {};
    alignas(64) PerCorner<std::uint32_t> narrowPerRow = {};
    alignas(64) PerCorner<std::int32_t> edge = {};
    alignas(64) PerCorner<std::int32_t> edgePerColumn = {};
    alignas(64) PerCorner<std::int32_t> edgePerRow = {};

    /// The edges as bounds of spans (boundinglines.h): two lower ones, two upper ones. Not set for
    /// small triangles.
    alignas(64) std::array<Array<double>, 4> lineConstant = {};
    alignas(64) std::array<Array<double>, 4> lineSlope = {};

    /// Up to this extent the edge functions of a block fit 32 bits: sides below 2^14 units, samples
    /// less than 2^14 + 2^12 units away, two products: below 2^30.
    static constexpr std::int32_t blockColumns = 32;
    static constexpr std::int32_t blockExtent = 63 * std::int32_t(unitsPerPixel);

    static bool contains(Set set, std::size_t i) { return (set >> i & 1) != 0; }
};

/// Prefetches a triangle that will be read soon. Any address is allowed: there need not be a
/// triangle.
inline void prefetchTriangle(std::uintptr_t address)
{
    constexpr std::uintptr_t cacheLine = 64;
    __builtin_prefetch(reinterpret_cast<const void *>(address));
    __builtin_prefetch(reinterpret_cast<const void *>(address + cacheLine));
}

} // namespace pixelplumb
