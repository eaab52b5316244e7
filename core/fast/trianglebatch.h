// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

#include <array>
#include <cstring>

namespace pixelplumb {

/// A few triangles as a structure of arrays: what a vector of triangles is set up from, and what
/// the set-up leaves for drawing them one after another. The arrays fit the first-level cache.
struct TriangleBatch {
    static constexpr std::size_t capacity = 32;
    template <class Value>
    using Array = std::array<Value, capacity>;
    template <class Value>
    using PerCorner = std::array<Array<Value>, 3>; ///< or per edge, per channel

    std::size_t size = 0;
    Array<const Triangle *> source = {};
    Array<bool> farAway = {}; ///< beyond ±2^15 px of the window: only the plain kernel draws it

    // Given: lattice units from the window's first sample, |each| <= 2^23; colours as 0x00bbggrr.
    alignas(64) PerCorner<std::int32_t> x = {};
    alignas(64) PerCorner<std::int32_t> y = {};
    alignas(64) PerCorner<std::uint32_t> colour = {};

    // Set up: the samples of the bounding box inside the window, counted from its first sample.
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
    /// 4 A' (n + 1): how many steps a colour word must tell apart (colourplane.h).
    alignas(64) Array<double> resolution = {};
    /// The largest of the colour plane's numbers, in steps of its word.
    alignas(64) Array<double> magnitude = {};
    /// The colour plane at the first sample of the box and its change per column and row.
    alignas(64) PerCorner<std::uint64_t> start = {};
    alignas(64) PerCorner<std::uint64_t> perColumn = {};
    alignas(64) PerCorner<std::uint64_t> perRow = {};

    /// Edge functions at the first sample of the box, at least 0 where the fill rule has the sample
    /// inside; meaningful while extent is at most blockExtent.
    alignas(64) PerCorner<std::int32_t> edge = {};
    alignas(64) PerCorner<std::int32_t> edgePerColumn = {};
    alignas(64) PerCorner<std::int32_t> edgePerRow = {};

    /// Not 0: neither empty nor of zero area, of at most 8 columns and rows of at most blockExtent,
    /// its 24-bit colours exact. Most triangles of a crowded scene, told apart at once.
    alignas(64) Array<double> isSmall = {};

    /// Up to this extent the edge functions of a block stay below 2^27: sides of at most 2^12
    /// units, samples at most 2 · 2^12 units away, two products.
    static constexpr std::int32_t blockExtent = 15 * std::int32_t(unitsPerPixel);

    explicit TriangleBatch(const FrameView &window)
        : m_firstX(Lattice(window.firstColumn) * unitsPerPixel)
        , m_firstY(Lattice(window.firstRow) * unitsPerPixel)
    {
    }

    /// Takes one more triangle; the batch must not be full.
    void append(const Triangle &triangle)
    {
        constexpr Lattice limit = Lattice(1) << 23;
        const std::size_t i = size;
        std::uint64_t beyond = 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vertex &vertex = triangle.vertices[corner];
            const Lattice fromLeft = vertex.position.x - m_firstX;
            const Lattice fromBottom = vertex.position.y - m_firstY;
            // At least 2^24 unless -2^23 <= coordinate < 2^23.
            beyond |= std::uint64_t(fromLeft + limit) | std::uint64_t(fromBottom + limit);
            x[corner][i] = std::int32_t(fromLeft);
            y[corner][i] = std::int32_t(fromBottom);
            colour[corner][i] = std::uint32_t(vertex.colour.channels[0])
                | std::uint32_t(vertex.colour.channels[1]) << 8
                | std::uint32_t(vertex.colour.channels[2]) << 16;
        }
        farAway[i] = beyond >= std::uint64_t(2 * limit);
        source[i] = &triangle;
        size = i + 1;
    }

    bool isFlat(std::size_t i) const
    {
        return colour[0][i] == colour[1][i] && colour[0][i] == colour[2][i];
    }

private:
    Lattice m_firstX;
    Lattice m_firstY;
};

} // namespace pixelplumb
