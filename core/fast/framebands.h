// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/triangle.h"

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

namespace pixelplumb {

/// The rows of a frame in bands that threads draw independently of each other.
class FrameBands {
public:
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
    int m_count;
    std::int32_t m_rowsPerBand;
};

/// The triangles of each band, in their order. Gathered in pieces of the scene, so that threads can
/// share the work and the order stays that of the scene whichever thread took which piece.
class BandBins {
public:
    static constexpr std::size_t trianglesPerPiece = 8192;

    BandBins(std::span<const Triangle> triangles, const FrameBands &bands);

    int pieceCount() const { return int(m_pieces.size()); }
    /// Sorts one piece of the scene into the bands.
    void gather(int piece);
    /// Calls `draw` with the triangles of a band, in order: a run of them from each piece.
    template <class Draw>
    void forEach(int band, const Draw &draw) const
    {
        for (const Piece &piece : m_pieces)
            draw(std::span<const Triangle>(piece[std::size_t(band)]));
    }

private:
    /// The triangles of a piece by band. Copies: a band's triangles stand far apart in the scene,
    /// and reading them from there costs a band more than drawing them.
    using Piece = std::vector<std::vector<Triangle>>;

    std::span<const Triangle> m_triangles;
    const FrameBands &m_bands;
    std::vector<Piece> m_pieces;
};

/// Does jobs 0 … count − 1, each once, on the calling thread and up to `threads` − 1 more of Qt's
/// global pool, and returns when all are done. Where the pool has no thread free the caller does
/// the work alone.
void doInParallel(int count, int threads, const std::function<void(int job)> &job);

} // namespace pixelplumb
