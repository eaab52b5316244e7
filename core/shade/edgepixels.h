// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/frameview.h"
#include "core/geometry/appearance.h"
#include "core/geometry/triangle.h"
#include "core/shade/rowrun.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace pixelplumb {

/// The pixels of a frame whose closed square meets an edge of some triangle: those with 4 or 16
/// samples.
class EdgePixels {
public:
    EdgePixels(std::span<const Triangle> triangles, const FrameView &frame);

    bool contains(std::int64_t x, std::int64_t y) const { return m_isEdge[place(x, y)] != 0; }
    std::int64_t count() const { return m_count; }

    /// Calls function(run) for each run of rows within `rows` of column x whose pixels all are, or
    /// all are not, edge pixels.
    template <class Function>
    void forEachRun(std::int64_t x, const RowRun &rows, bool ofEdges,
                    const Function &function) const
    {
        const std::span<const std::int64_t> borders = bordersIn(x);
        auto border = std::upper_bound(borders.begin(), borders.end(), rows.first);
        bool isEdge = (border - borders.begin()) % 2 != 0;
        for (RowRun run = rows; run.first < rows.end; run.first = run.end, isEdge = !isEdge) {
            run.end = border == borders.end() ? rows.end : std::min(*border++, rows.end);
            if (isEdge == ofEdges)
                function(run);
        }
    }

private:
    std::size_t place(std::int64_t x, std::int64_t y) const
    {
        return std::size_t(x - m_frame.firstColumn) * std::size_t(m_frame.height)
            + std::size_t(y - m_frame.firstRow);
    }
    /// The rows at which the column switches to edge pixels and, in turn, back, ascending.
    std::span<const std::int64_t> bordersIn(std::int64_t x) const
    {
        const auto column = std::size_t(x - m_frame.firstColumn);
        return std::span(m_borders).subspan(m_firstBorder[column],
                                            m_firstBorder[column + 1] - m_firstBorder[column]);
    }
    void addEdge(LatticePoint a, LatticePoint b);
    void findBorders();

    FrameView m_frame; ///< used only as a window
    std::vector<std::uint8_t> m_isEdge; ///< column by column
    std::int64_t m_count = 0;
    std::vector<std::int64_t> m_borders;
    std::vector<std::size_t> m_firstBorder; ///< where each column begins in m_borders, and the end
};

/// Offsets of a pixel's samples from its own sample, 1/256 px; y upward.
std::span<const LatticePoint> samplePattern(Antialiasing antialiasing);

/// The triangle as seen from one of these samples: moved the opposite way.
Triangle seenFrom(const Triangle &triangle, const LatticePoint &sample);

} // namespace pixelplumb
