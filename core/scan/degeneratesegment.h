// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/triangle.h"

#include <utility>

namespace pixelplumb {

/// What a triangle of zero area covers under the closed rule: the segment L₀₂ between its extreme
/// vertices in (x, y) order, or one point. Edge functions cannot describe it (all weights are 0/0),
/// so methods based on them decide it here, in integers, whatever their arithmetic.
class DegenerateSegment {
public:
    DegenerateSegment() = default;
    explicit DegenerateSegment(const Triangle &triangle)
    {
        const std::array<int, 3> order = sortedByColumn(triangle);
        m_first = triangle.vertices[std::size_t(order[0])];
        m_last = triangle.vertices[std::size_t(order[2])];
    }

    const Vertex &first() const { return m_first; }
    const Vertex &last() const { return m_last; }

    bool covers(std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        return sample >= m_first.position && sample <= m_last.position
            && doubledArea(m_first.position, m_last.position, sample) == 0;
    }

    /// The level of a channel at a sample on the segment: numerator and denominator > 0.
    std::pair<Int128, Int128> level(std::size_t channel, std::int64_t x, std::int64_t y) const
    {
        const LatticePoint sample = latticePixel(x, y);
        const Int128 from = m_first.colour.channels[channel];
        const Int128 rise = m_last.colour.channels[channel] - from;
        const Int128 width = m_last.position.x - m_first.position.x;
        if (width > 0)
            return {from * width + rise * (sample.x - m_first.position.x), width};
        const Int128 height = m_last.position.y - m_first.position.y;
        if (height > 0)
            return {from * height + rise * (sample.y - m_first.position.y), height};
        return {from, 1};
    }

private:
    Vertex m_first;
    Vertex m_last;
};

} // namespace pixelplumb
