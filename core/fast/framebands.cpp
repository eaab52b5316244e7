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
    const Lattice lowest = std::min({v[0].position.y, v[1].position.y, v[2].position.y});
    const Lattice highest = std::max({v[0].position.y, v[1].position.y, v[2].position.y});
    const std::int64_t first = ceilPixel(lowest) - m_frame.firstRow;
    const std::int64_t last = floorPixel(highest) - m_frame.firstRow;
    if (last < 0 || first >= m_frame.height || first > last)
        return {1, 0};
    return {m_bandOfRow[std::size_t(std::max<std::int64_t>(first, 0))],
            m_bandOfRow[std::size_t(std::min<std::int64_t>(last, m_frame.height - 1))]};
}

int BandBins::begin(std::span<const Triangle> triangles)
{
    m_triangles = triangles;
    m_pieceCount = (triangles.size() + trianglesPerPiece - 1) / trianglesPerPiece;
    if (m_pieces.size() < m_pieceCount)
        m_pieces.resize(m_pieceCount, Piece(std::size_t(m_bands.count())));
    return int(m_pieceCount);
}

void BandBins::gather(int piece)
{
    Piece &bins = m_pieces[std::size_t(piece)];
    for (std::vector<std::uint32_t> &bin : bins)
        bin.clear();
    const std::size_t first = std::size_t(piece) * trianglesPerPiece;
    const std::size_t end = std::min(first + trianglesPerPiece, m_triangles.size());
    for (std::size_t i = first; i < end; ++i) {
        const FrameBands::Range touched = m_bands.touchedBy(m_triangles[i]);
        for (int band = touched.first; band <= touched.last; ++band)
            bins[std::size_t(band)].push_back(std::uint32_t(i));
    }
}

} // namespace pixelplumb
