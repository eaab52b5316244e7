// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

#include <atomic>
#include <span>
#include <vector>

namespace pixelplumb {

/// The rows of a frame, divided into bands that threads draw independently.
class FrameBands {
public:
    /// `count` bands at most.
    FrameBands(FrameView frame, int count);

    int count() const { return m_count; }
    FrameView band(int index) const;

    /// The first and the last band with a row in a triangle's bounding box; first > last where
    /// there is none.
    struct Range {
        int first;
        int last;
    };
    Range touchedBy(const Triangle &triangle) const;

private:
    FrameView m_frame;
    std::int32_t m_rowsPerBand;
    int m_count;
    std::vector<std::uint16_t> m_bandOfRow; ///< saves two divisions per triangle
};

/// Which triangles of a scene belong to each band, in scene order. The drawing threads gather them
/// in pieces of the scene, as they need them: no thread waits until all pieces are gathered, and
/// the order does not depend on which thread took which piece. The memory is reused for one part of
/// a scene after another: getting fresh memory from the system costs more than filling it.
class BandBins {
public:
    explicit BandBins(const FrameBands &bands);

    /// In one part of a scene.
    static constexpr std::size_t mostTriangles = 65'536;
    /// Discards what was gathered and begins another part. No thread may be reading.
    void begin(std::span<const Triangle> triangles);
    /// Calls `draw` with each piece of the part, in order, and the places in that piece of a band's
    /// triangles. Several threads may call it at once.
    template <class Draw>
    void forEach(int band, const Draw &draw)
    {
        for (std::size_t piece = 0; piece < m_pieceCount; ++piece) {
            await(m_pieces[piece]);
            const std::vector<Bin> &bins = m_pieces[piece].bins;
            draw(trianglesOf(piece), std::span<const std::uint16_t>(bins[std::size_t(band)]));
        }
    }

private:
    static constexpr std::size_t trianglesPerPiece = 2048;

    using Bin = std::vector<std::uint16_t>; ///< places in the piece
    struct Piece {
        std::vector<Bin> bins; ///< by band
        std::atomic<bool> isGathered = false;
    };

    std::span<const Triangle> trianglesOf(std::size_t piece) const;
    /// Gathers pieces that no thread has begun, until this one is gathered.
    void await(const Piece &piece);
    void gather(std::size_t piece);

    const FrameBands &m_bands;
    std::span<const Triangle> m_triangles;
    std::vector<Piece> m_pieces;
    std::size_t m_pieceCount = 0; ///< pieces of m_pieces in use
    std::atomic<std::size_t> m_nextPiece = 0; ///< the first that no thread has begun
};

} // namespace pixelplumb
