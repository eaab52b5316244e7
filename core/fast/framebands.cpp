// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/framebands.h"

#include <algorithm>

namespace pixelplumb {

FrameBands::FrameBands(FrameView frame, int count)
    : m_frame(frame)
    , m_rowsPerBand((frame.height + count - 1) / count)
    , m_count((frame.height + m_rowsPerBand - 1) / m_rowsPerBand)
    , m_bandOfRow(std::size_t(frame.height))
{
    for (std::int32_t row = 0; row < frame.height; ++row)
        m_bandOfRow[std::size_t(row)] = std::uint16_t(row / m_rowsPerBand);
}

FrameView FrameBands::band(int index) const
{
    FrameView band = m_frame;
    const std::int32_t skipped = index * m_rowsPerBand;
    band.base += std::ptrdiff_t(skipped) * band.stride;
    band.firstRow += skipped;
    band.height = std::min(m_rowsPerBand, m_frame.height - skipped);
    return band;
}

FrameBands::Range FrameBands::touchedBy(const Triangle &triangle) const
{
    const auto &v = triangle.vertices;
    // Pairwise, because the minimum of a list of three would compile to unpredictable branches.
    const Lattice lower = std::min(v[0].position.y, v[1].position.y);
    const Lattice higher = std::max(v[0].position.y, v[1].position.y);
    const Lattice lowest = std::min(lower, v[2].position.y);
    const Lattice highest = std::max(higher, v[2].position.y);
    const std::int64_t first = ceilPixel(lowest) - m_frame.firstRow;
    const std::int64_t last = floorPixel(highest) - m_frame.firstRow;
    if (last < 0 || first >= m_frame.height || first > last)
        return {1, 0};
    return {m_bandOfRow[std::size_t(std::max<std::int64_t>(first, 0))],
            m_bandOfRow[std::size_t(std::min<std::int64_t>(last, m_frame.height - 1))]};
}

BandBins::BandBins(const FrameBands &bands)
    : m_bands(bands)
    , m_pieces(mostTriangles / trianglesPerPiece)
{
    for (Piece &piece : m_pieces)
        piece.bins.resize(std::size_t(bands.count()));
}

void BandBins::begin(std::span<const Triangle> triangles)
{
    Q_ASSERT(triangles.size() <= mostTriangles);
    m_triangles = triangles;
    m_pieceCount = (triangles.size() + trianglesPerPiece - 1) / trianglesPerPiece;
    for (std::size_t piece = 0; piece < m_pieceCount; ++piece)
        m_pieces[piece].isGathered = false;
    m_nextPiece = 0;
}

std::span<const Triangle> BandBins::trianglesOf(std::size_t piece) const
{
    const std::size_t first = piece * trianglesPerPiece;
    return m_triangles.subspan(first, std::min(trianglesPerPiece, m_triangles.size() - first));
}

void BandBins::await(const Piece &piece)
{
    while (!piece.isGathered) {
        const std::size_t mine = m_nextPiece++;
        if (mine < m_pieceCount)
            gather(mine);
        else
            piece.isGathered.wait(false);
    }
}

void BandBins::gather(std::size_t piece)
{
    std::vector<Bin> &bins = m_pieces[piece].bins;
    const std::size_t expected = 2 * trianglesPerPiece / bins.size();
    for (Bin &bin : bins) {
        bin.clear();
        bin.reserve(expected);
    }
    const std::span<const Triangle> triangles = trianglesOf(piece);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const FrameBands::Range touched = m_bands.touchedBy(triangles[i]);
        for (int band = touched.first; band <= touched.last; ++band)
            bins[std::size_t(band)].push_back(std::uint16_t(i));
    }
    m_pieces[piece].isGathered = true;
    m_pieces[piece].isGathered.notify_all();
}

} // namespace pixelplumb
