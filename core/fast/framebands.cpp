// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fast/framebands.h"

#include <QSemaphore>
#include <QThreadPool>

#include <algorithm>
#include <atomic>

namespace pixelplumb {

FrameBands::FrameBands(FrameView frame, int count)
    : m_frame(frame)
    , m_count(count)
    , m_rowsPerBand((frame.height + count - 1) / count)
{
    m_count = (frame.height + m_rowsPerBand - 1) / m_rowsPerBand;
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
    const auto bandOf
        = [&](std::int64_t row) { return int(std::uint32_t(row) / std::uint32_t(m_rowsPerBand)); };
    return {bandOf(std::max<std::int64_t>(first, 0)),
            bandOf(std::min<std::int64_t>(last, m_frame.height - 1))};
}

BandBins::BandBins(std::span<const Triangle> triangles, const FrameBands &bands)
    : m_triangles(triangles)
    , m_bands(bands)
    , m_pieces((triangles.size() + trianglesPerPiece - 1) / trianglesPerPiece)
{
}

void BandBins::gather(int piece)
{
    const std::size_t first = std::size_t(piece) * trianglesPerPiece;
    const std::size_t count = std::min(trianglesPerPiece, m_triangles.size() - first);
    std::vector<FrameBands::Range> touched(count);
    std::vector<std::size_t> sizes(std::size_t(m_bands.count()));
    for (std::size_t n = 0; n < count; ++n) {
        touched[n] = m_bands.touchedBy(m_triangles[first + n]);
        for (int band = touched[n].first; band <= touched[n].last; ++band)
            ++sizes[std::size_t(band)];
    }
    Piece bins(sizes.size());
    for (std::size_t band = 0; band < bins.size(); ++band)
        bins[band].reserve(sizes[band]);
    for (std::size_t n = 0; n < count; ++n) {
        for (int band = touched[n].first; band <= touched[n].last; ++band)
            bins[std::size_t(band)].push_back(m_triangles[first + n]);
    }
    m_pieces[std::size_t(piece)] = std::move(bins);
}

void doInParallel(int count, int threads, const std::function<void(int job)> &job)
{
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int mine = next++; mine < count; mine = next++)
            job(mine);
    };
    QSemaphore finished;
    int started = 0;
    while (started < threads - 1 && started < count - 1) {
        if (!QThreadPool::globalInstance()->tryStart([&] {
                work();
                finished.release();
            }))
            break;
        ++started;
    }
    work();
    finished.acquire(started);
}

} // namespace pixelplumb
