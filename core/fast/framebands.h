// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

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

/// Which triangles of a scene each band has, in their order. Gathered in pieces of the scene, so
/// that threads can share the work and the order stays that of the scene whichever thread took
/// which piece. Its memory serves one part of a scene after another: to get fresh memory from the
/// system costs more than to fill it.
class BandBins {
public:
    static constexpr std::size_t trianglesPerPiece = 4096;

    explicit BandBins(const FrameBands &bands)
        : m_bands(bands)
    {
    }

    /// Forgets what was gathered; returns how many pieces gather() has to be called for.
    int begin(std::span<const Triangle> triangles);
    /// Sorts one piece into the bands. Different pieces may be gathered at once.
    void gather(int piece);
    /// Calls `draw` with the places of a band's triangles in the scene, in order: a run of them
    /// from each piece.
    template <class Draw>
    void forEach(int band, const Draw &draw) const
    {
        for (std::size_t piece = 0; piece < m_pieceCount; ++piece)
            draw(std::span<const std::uint32_t>(m_pieces[piece][std::size_t(band)]));
    }

private:
    using Piece = std::vector<std::vector<std::uint32_t>>; ///< by band

    const FrameBands &m_bands;
    std::span<const Triangle> m_triangles;
    std::vector<Piece> m_pieces;
    std::size_t m_pieceCount = 0; ///< of m_pieces, in use
};

} // namespace pixelplumb
