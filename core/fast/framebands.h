// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

#include <atomic>
#include <span>
#include <vector>

namespace pixelplumb {

/// The rows of a frame in bands that threads draw independently of each other.
class FrameBands {
public:
    /// `count` bands at most.
    FrameBands(FrameView frame, int count);

    int count() const { return m_count; }
    FrameView band(int index) const;

    /// The first and the last band with a row within a triangle's bounding box; first > last where
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
    std::vector<std::uint16_t> m_bandOfRow; ///< spares two divisions a triangle
};

/// Which triangles of a scene each band has, in their order. Gathered in pieces of the scene by the
/// threads that draw, as they need them: nobody waits until all pieces are gathered, and the order
/// is that of the scene whichever thread took which piece. Its memory serves one part of a scene
/// after another: to get fresh memory from the system costs more than to fill it.
class BandBins {
public:
    explicit BandBins(const FrameBands &bands);

    /// Of one part of a scene.
    static constexpr std::size_t mostTriangles = 65'536;
    /// Forgets what was gathered, and takes up another part. Nobody may be reading.
    void begin(std::span<const Triangle> triangles);
    /// Calls `draw` with each piece of the part, in order, and the places in it of a band's
    /// triangles. Several threads may do so at once.
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
    /// Gathers pieces that nobody has begun, until this one is gathered.
    void await(const Piece &piece);
    void gather(std::size_t piece);

    const FrameBands &m_bands;
    std::span<const Triangle> m_triangles;
    std::vector<Piece> m_pieces;
    std::size_t m_pieceCount = 0; ///< of m_pieces, in use
    std::atomic<std::size_t> m_nextPiece = 0; ///< that nobody has begun
};

} // namespace pixelplumb
